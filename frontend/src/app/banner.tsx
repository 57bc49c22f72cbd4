import { say, t } from "../i18n";
import { usePage } from "../model/page";

/** A banner while nothing can be changed here. */
export function ReadOnlyBanner() {
  const reason = usePage().context.program.readOnly.value;
  return (
    <div role="status" class={reason ? "banner calm" : "hidden"}>
      {reason && say(reason)}
    </div>
  );
}

/** A banner while the server cannot be reached. */
export function ConnectionBanner() {
  const { connection } = usePage().context;
  const state = connection.state.value;
  const lost = state === "lost" || state === "refused";
  return (
    <div role="alert" class={lost ? "banner" : "hidden"}>
      {lost && t(state === "lost" ? "page-shell-lost" : "page-shell-refused")}
    </div>
  );
}
