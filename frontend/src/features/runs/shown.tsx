/** Says which run is shown if it is not the newest one, and leads back. */

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { runTitle } from "../../model/run-title";
import { Icon } from "../../ui/icons";
import "./runs.css";

export function ShownRun() {
  const { context, keptRuns, project } = usePage();
  const { kept, remarks } = context.running;
  const run = kept.value;
  if (!run) return null;
  const notes = [
    ...(keptRuns.changed.value ? [t(run.foreign ? "page-runs-other-program" : "page-runs-changed")] : []),
    ...remarks.value.map(say),
  ];
  return (
    <div class="shown-run" role="status">
      <Icon name="video" />
      <p>
        <strong>{t("page-runs-shown", { name: runTitle(run) })}</strong> {notes.join(" ")}{" "}
        {keptRuns.changed.value && run.version && context.program.readOnly.value === null && (
          <button
            type="button"
            class="text-link moment-link"
            onClick={() => run.version && project.restore(run.version)}
          >
            {t("page-runs-restore")}
          </button>
        )}
      </p>
      <button
        type="button"
        class="button bordered"
        aria-label={t("page-runs-back")}
        title={t("page-runs-back")}
        onClick={() => keptRuns.close()}
      >
        {t("page-runs-newest")}
      </button>
    </div>
  );
}
