/** Trying the connection that the saved settings of a robot describe. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { Icon } from "../../ui/icons";

interface Props {
  readonly robot: string;
  /** What the user calls it. */
  readonly title: string;
  /** Whether the settings on the screen are those that are tried. */
  readonly isSaved: boolean;
}

/** A button that connects to a robot, says what has answered or what to do, and lets go of it. */
export function TestConnection({ robot, title, isSaved }: Props) {
  const { connect } = usePage();
  const tested = useSignal(false);
  const answered = useSignal(false);
  const state = tested.value ? connect.state.value.state : "none";
  useEffect(() => {
    if (state !== "connected") return;
    answered.value = true;
    connect.disconnect();
  }, [state]);
  useEffect(() => () => connect.disconnect(), []);
  const test = () => {
    tested.value = true;
    answered.value = false;
    connect.connect(robot);
  };
  return (
    <div class="test-connection">
      <button
        type="button"
        class="button soft"
        disabled={!isSaved || state === "connecting"}
        title={isSaved ? undefined : t("page-robots-test-unsaved")}
        onClick={test}
      >
        <Icon name="wifi" />
        {t("page-robots-test")}
      </button>
      <span role="status">
        {state === "connecting" && t("page-connect-state-connecting", { robot: title })}
        {answered.value && (
          <span class="connect-yes">
            <Icon name="check" />
            {t("page-robots-test-answered", { robot: title })}
          </span>
        )}
      </span>
      <p role="alert" class="refused">
        {tested.value && <Problem title={title} />}
      </p>
    </div>
  );
}

function Problem({ title }: { readonly title: string }) {
  const { requests, state } = usePage().connect;
  const { state: reached, problem } = state.value;
  if (requests.refusal.value) return <>{say(requests.refusal.value)}</>;
  if (reached !== "failed" && reached !== "lost") return null;
  return <>{problem ? say(problem) : t(`page-connect-state-${reached}`, { robot: title })}</>;
}
