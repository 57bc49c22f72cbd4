import { t } from "../../i18n";
import { usePage } from "../page";

/** Says when the server is out of reach, and what that means. */
export function ConnectionBanner() {
  const { connection } = usePage().context;
  const state = connection.state.value;
  const lost = state === "lost" || state === "refused";
  return (
    <div role="alert" class={lost ? "banner" : "hidden"}>
      {lost && t(state === "lost" ? "chrome.lost" : "chrome.refused")}
    </div>
  );
}
