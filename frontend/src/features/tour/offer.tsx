/** The offer of the tour to new users, over the page, so that nothing moves when it is answered. */

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { prefer, preferences } from "../../model/preferences";
import { isNarrow } from "../../ui/screen";
import "./tour.css";

/** Blocks of a program that end above the offer, and on a phone. */
const SHORT = 6;
const SHORT_ON_PHONE = 2;

export function TourOffer() {
  const page = usePage();
  const { dialogs } = page;
  if (preferences.value.tourDone || dialogs.tour.value || isGuided(page) || isLong(page)) return null;
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

/** In a class the teacher says what to do, and a lesson says it itself. */
function isGuided({ classNews, lessons }: Page): boolean {
  return classNews.now.value !== null || lessons.shown.value !== null;
}

/** Whether the offer would cover the program's last blocks. */
function isLong({ context }: Page): boolean {
  return context.program.state.value.places.length > (isNarrow.value ? SHORT_ON_PHONE : SHORT);
}
