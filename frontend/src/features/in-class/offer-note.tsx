/** What a pupil's page says about programs that classmates show, one after the other. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";

export function OfferNote() {
  const { shownPrograms } = usePage();
  const [offer] = shownPrograms.now.value?.offers ?? [];
  if (!offer) return null;
  const { pupil, name, project } = offer;
  return (
    <section class="toast note">
      <p>{t("page-show-offer", { name, project })}</p>
      <button type="button" class="button filled" onClick={() => shownPrograms.answer(pupil, true)}>
        {t("page-show-open")}
      </button>
      <button type="button" class="button bordered" onClick={() => shownPrograms.answer(pupil, false)}>
        {t("page-show-not-now")}
      </button>
    </section>
  );
}
