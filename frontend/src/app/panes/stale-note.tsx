/** A note that one view has an error, so the others show an older program; it leads to the error. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Problem } from "../../protocol/messages";
import { Icon } from "../../ui/icons";

export function StaleNote() {
  const { context, views } = usePage();
  const { stale, origin, problems } = context.program.state.value;
  if (stale.length === 0) return null;
  const errors = problems.filter((one) => one.severity === "error");
  const first = errors.find((one) => one.view === origin) ?? errors[0];
  const note = text(first, t(`page-shell-${origin}`));
  return (
    <div class="stale-note" title={note}>
      <Icon name="warning" />
      <span>{note}</span>
      {first && (
        <button type="button" class="button bordered" onClick={() => views.goTo(first)}>
          {t("page-problems-go-to")}
        </button>
      )}
    </div>
  );
}

function text(problem: Problem | undefined, view: string): string {
  const line = problem?.line ?? 0;
  return line > 0 ? t("page-problems-stale", { view, line }) : t("page-problems-stale-somewhere", { view });
}
