/** The offer of the tour to new users, over the page, so that nothing moves when it is answered. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer, preferences } from "../../model/preferences";
import "./tour.css";

export function TourOffer() {
  const { classNews, dialogs } = usePage();
  // In a class the teacher says what to do.
  const inClass = classNews.now.value !== null;
  if (preferences.value.tourDone || dialogs.tour.value || inClass) return null;
  return (
    <section class="toast tour-offer" aria-label={t("page-tour-title")}>
      <p>{t("page-tour-offer")}</p>
      <button type="button" class="button filled" onClick={() => (dialogs.tour.value = true)}>
        {t("page-tour-begin")}
      </button>
      <button type="button" class="button bordered" onClick={() => prefer({ tourDone: true })}>
        {t("page-tour-decline")}
      </button>
    </section>
  );
}
