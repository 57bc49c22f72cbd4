/** Finds out with the user why a robot is not found, while it is looked for all the time. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { type Aside, ROBOT } from "./aside";
import { questions } from "./help";
import { kindTitle } from "./names";

interface Props {
  readonly robot: string;
  readonly show: (next: Aside) => void;
}

export function HelpMe({ robot, show }: Props) {
  const { connect, project } = usePage();
  const at = useSignal(0);
  const title = kindTitle(project.welcome.value?.robots ?? [], robot);
  const found = connect.lists.value.found.find((one) => one.robot === robot);
  if (found) {
    return (
      <div class="connect-help found">
        <RobotPicture robot={robot} />
        <p role="status" class="connect-yes">
          <Icon name="check" />
          {t("page-connect-help-found", { robot: title })}
        </p>
        <div class="actions">
          <button type="button" class="button filled" onClick={() => connect.connect(found.id)}>
            {t("page-connect-connect")}
          </button>
        </div>
      </div>
    );
  }
  const asked = questions(robot);
  const code = asked[at.value];
  return (
    <div class="connect-help">
      <RobotPicture robot={robot} />
      <p class="dim" role="status">
        {code
          ? t("page-connect-help-step", { step: at.value + 1, steps: asked.length })
          : t("page-connect-help-end", { robot: title })}
      </p>
      {code && (
        <div aria-live="polite">
          <h3>{t(code)}</h3>
          <p>{t(`${code}-do`)}</p>
        </div>
      )}
      <p class="connect-looking">
        <Icon name="refresh" />
        {t("page-connect-help-looking", { robot: title })}
      </p>
      <div class="actions">
        <button type="button" class="button bordered" onClick={() => (at.value > 0 ? at.value-- : show(ROBOT))}>
          {t("page-connect-back")}
        </button>
        {code ? (
          <button type="button" class="button filled" onClick={() => at.value++}>
            {t("page-connect-help-yes")}
          </button>
        ) : (
          <button type="button" class="button filled" onClick={() => show({ what: "address", robot })}>
            {t("page-connect-address")}
          </button>
        )}
      </div>
    </div>
  );
}
