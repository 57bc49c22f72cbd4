/** The world of the classmate who has invited the pupil, in the place of the pupil's own. */

import { language, t } from "../../i18n";
import { usePage } from "../../model/page";
import "./pairs.css";

/** Whether a guest's page shows the host's world now. */
export function useHostWorld(): boolean {
  const { classNews, pairs, project } = usePage();
  const isGuest = classNews.now.value?.role === "pupil" && pairs.now.value?.state === "guest";
  return isGuest && pairs.isAway.value && !project.atStart.value;
}

export function HostWorld() {
  const title = t("page-pair-world", { name: usePage().pairs.now.value?.other ?? "" });
  return (
    <section class="region world-pane host-world" aria-label={title} data-region="host-world" tabIndex={-1}>
      <iframe key={language.value} src={guestPath(location.pathname)} title={title} />
    </section>
  );
}

/** From the path of the pupil's page, which ends in the pupil's id. */
export function guestPath(path: string): string {
  return path.replace(/p\/([^/]+)\/[^/]*$/, "p/guest-$1/");
}
