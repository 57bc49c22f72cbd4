/** Says which view has an error while the others wait for its end, and leads there. */

import { t } from "../../i18n";
import type { Problem } from "../../messages";
import { Icon } from "../widgets/icons";
import { usePage } from "../page";

export function StaleNote() {
  const { context, views } = usePage();
  const { stale, origin, problems } = context.program.state.value;
  if (stale.length === 0) return null;
  const errors = problems.filter((one) => one.severity === "error");
  const first = errors.find((one) => one.view === origin) ?? errors[0];
  return (
    <div class="stale-note">
      <Icon name="warning" />
      <span>{text(first, t(`chrome.${origin}`))}</span>
      {first && (
        <button type="button" class="button bordered" onClick={() => views.goTo(first)}>
          {t("problems.goTo")}
        </button>
      )}
    </div>
  );
}

function text(problem: Problem | undefined, view: string): string {
  const line = problem?.line ?? 0;
  return line > 0 ? t("problems.stale", { view, line }) : t("problems.staleSomewhere", { view });
}
