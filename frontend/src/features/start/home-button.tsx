import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Logo } from "./logo";

/** The logo in the bar of the working page, which leads to the start page. */
export function HomeButton() {
  const { project } = usePage();
  const name = t("page-start-home");
  return (
    <button type="button" class="button home-button" title={name} aria-label={name} onClick={() => project.leave()}>
      <Logo size={32} />
    </button>
  );
}
