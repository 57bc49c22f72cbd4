import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { PastRun, Version } from "../../messages";
import { date } from "./dates";
import { Dialog } from "../widgets/dialog";
import { usePage } from "../page";
import { ending } from "../result";

/** What was: versions to go back to, and runs with what came of them. */
export function HistoryDialog() {
  const { dialogs, project } = usePage();
  useEffect(() => project.listHistory(), []);
  const history = project.history.value;
  return (
    <Dialog title={t("history.title")} close={() => dialogs.close()} size="large">
      <div class="two-columns">
        <section>
          <h3>{t("history.versions")}</h3>
          {history?.versions.length === 0 && <p>{t("history.noVersions")}</p>}
          <ul class="rows">{history?.versions.map((one) => <VersionRow key={one.id} version={one} />)}</ul>
        </section>
        <section>
          <h3>{t("history.runs")}</h3>
          {history?.runs.length === 0 && <p>{t("history.noRuns")}</p>}
          <ul class="rows">{history?.runs.map((one) => <RunRow key={one.time} run={one} />)}</ul>
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
    <button type="button" class="button bordered" aria-label={t("history.restoreOf", { date: date(time) })} onClick={restore}>
      {t("history.restore")}
    </button>
  );
}

function VersionRow({ version: { id, time, reason, lines } }: { version: Version }) {
  return (
    <li>
      <div class="row-main">
        <strong>{date(time)}</strong>
        <span class="dim">
          {t(`history.reason_${reason}`)} · {t("history.lines", { lines })}
        </span>
      </div>
      <RestoreButton version={id} time={time} />
    </li>
  );
}

function RunRow({ run }: { run: PastRun }) {
  const { project } = usePage();
  const parts = [ending(run.ended), `${run.seconds.toFixed(1)} s`, ...run.goals];
  return (
    <li>
      <div class="row-main">
        <strong>{date(run.time)}</strong>
        <span>{parts.join(" · ")}</span>
        <span class="dim">{t("project.onIn", { robot: project.robotTitle(run.robot), world: project.worldTitle(run.world) })}</span>
        <span class="dim hash" title={run.trace_sha256}>
          {t("problems.trace")} {run.trace_sha256.slice(0, 12)}
        </span>
      </div>
      {run.version && <RestoreButton version={run.version} time={run.time} />}
    </li>
  );
}
