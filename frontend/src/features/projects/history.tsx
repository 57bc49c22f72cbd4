import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { ending } from "../../model/run-result";
import type { PastRun, Version } from "../../protocol/messages";
import { date } from "../../ui/dates";
import { Dialog } from "../../ui/dialog";

/** The project's history: versions to restore, and runs with their results. */
export function HistoryDialog() {
  const { dialogs, project } = usePage();
  useEffect(() => project.listHistory(), []);
  const history = project.history.value;
  return (
    <Dialog title={t("page-history-title")} close={() => dialogs.close()} size="large">
      <div class="two-columns">
        <section>
          <h3>{t("page-history-versions")}</h3>
          {history?.versions.length === 0 && <p>{t("page-history-no-versions")}</p>}
          <ul class="rows">
            {history?.versions.map((one) => (
              <VersionRow key={one.id} version={one} />
            ))}
          </ul>
        </section>
        <section>
          <h3>{t("page-history-runs")}</h3>
          {history?.runs.length === 0 && <p>{t("page-history-no-runs")}</p>}
          <ul class="rows">
            {history?.runs.map((one) => (
              <RunRow key={one.time} run={one} />
            ))}
          </ul>
        </section>
      </div>
    </Dialog>
  );
}

function RestoreButton({ version, time }: { version: string; time: number }) {
  const { dialogs, project } = usePage();
  const restore = () => {
    dialogs.close();
    project.restore(version);
  };
  return (
    <button
      type="button"
      class="button bordered"
      aria-label={t("page-history-restore-of", { date: date(time) })}
      onClick={restore}
    >
      {t("page-history-restore")}
    </button>
  );
}

function VersionRow({ version: { id, time, reason, lines } }: { version: Version }) {
  return (
    <li>
      <div class="row-main">
        <strong>{date(time)}</strong>
        <span class="dim">
          {t(`page-history-reason-${reason}`)} · {t("page-history-lines", { lines })}
        </span>
      </div>
      <RestoreButton version={id} time={time} />
    </li>
  );
}

function RunRow({ run }: { run: PastRun }) {
  const { project } = usePage();
  // Several robots are separated by commas.
  const titles = (robots: string) =>
    robots
      .split(", ")
      .map((one) => project.robotTitle(one))
      .join(", ");
  const parts = [ending(run.ended), `${run.seconds.toFixed(1)} s`, ...run.goals];
  return (
    <li>
      <div class="row-main">
        <strong>{date(run.time)}</strong>
        <span>{parts.join(" · ")}</span>
        <span class="dim">
          {t("page-project-on-in", { robot: titles(run.robot), world: project.worldTitle(run.world) })}
        </span>
        {run.trace_sha256 && (
          <span class="dim hash" title={run.trace_sha256}>
            {t("page-problems-trace")} {run.trace_sha256.slice(0, 12)}
          </span>
        )}
      </div>
      {run.version && <RestoreButton version={run.version} time={run.time} />}
    </li>
  );
}
