/** The offer of the tour to new users, in a row of its own: it covers nothing of the page. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer, preferences } from "../../model/preferences";
import "./tour.css";

export function TourOffer() {
  const { dialogs } = usePage();
  if (preferences.value.tourDone || dialogs.tour.value) return null;
  return (
    <section class="tour-offer" aria-label={t("page-tour-title")}>
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
