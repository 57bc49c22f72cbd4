/** The project's kept runs: look back at one, name it, download it, delete it, open one from another computer. */

import { useSignalEffect } from "@preact/signals";

import { t } from "../../i18n";
import { RUN_FILE } from "../../model/kept-runs";
import { type Page, usePage } from "../../model/page";
import { ending } from "../../model/run-result";
import { runTitle } from "../../model/run-title";
import type { KeptRun } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { chooseFile } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { Comparison } from "./comparison";
import "./runs.css";

export function Runs() {
  const page = usePage();
  const { keptRuns, views, context, project } = page;
  useSignalEffect(() => {
    // A page that is reloaded has no project at first.
    if (views.showsPanel("runs") && project.name.value && keptRuns.runs.value === null) keptRuns.list();
  });
  const runs = keptRuns.runs.value ?? [];
  const isReadOnly = context.program.readOnly.value !== null;
  return (
    <div class="runs">
      <div class="runs-head">
        <button
          type="button"
          class="button bordered"
          disabled={keptRuns.chosen.value.length < 2 || context.running.active.value}
          title={t("page-runs-compare-help")}
          onClick={() => keptRuns.compare()}
        >
          <Icon name="split" />
          {t("page-runs-compare")}
        </button>
        <button
          type="button"
          class="button bordered"
          disabled={isReadOnly}
          onClick={() => chooseFile(RUN_FILE, (file) => void keptRuns.import(file))}
        >
          <Icon name="upload" />
          {t("page-runs-open-file")}
        </button>
      </div>
      <Comparison />
      {keptRuns.runs.value?.length === 0 && <p class="dim">{t("page-runs-none")}</p>}
      <ul class="rows" aria-label={t("page-shell-runs")}>
        {runs.map((run) => (
          <Row key={run.id} run={run} isReadOnly={isReadOnly} />
        ))}
      </ul>
    </div>
  );
}

function Row({ run, isReadOnly }: { run: KeptRun; isReadOnly: boolean }) {
  const page = usePage();
  const { keptRuns, context } = page;
  const { running } = context;
  const isShown = running.kept.value?.id === run.id;
  const off = (run.damaged ?? false) || running.active.value;
  return (
    <li class={isShown ? "run-row shown" : "run-row"}>
      <label class="run-choice" title={t("page-runs-choose", { name: runTitle(run) })}>
        <input
          type="checkbox"
          aria-label={t("page-runs-choose", { name: runTitle(run) })}
          checked={keptRuns.chosen.value.includes(run.id)}
          disabled={run.damaged}
          onChange={({ currentTarget }) => keptRuns.choose(run.id, currentTarget.checked)}
        />
      </label>
      <button
        type="button"
        class="row-main"
        aria-pressed={isShown}
        disabled={off}
        onClick={() => (isShown ? keptRuns.close() : keptRuns.open(run.id))}
      >
        <strong>{runTitle(run)}</strong>
        <span class="dim">{run.damaged ? t("page-runs-damaged") : factsOf(page, run).join(" · ")}</span>
      </button>
      <Tools run={run} isReadOnly={isReadOnly} />
    </li>
  );
}

/** How it ended, how long it was, its goals, its robot and its world. */
function factsOf({ project }: Page, run: KeptRun): string[] {
  const { ended = "", seconds = 0, reached = [], missed = 0, robot = "", world = "" } = run;
  const facts = [ended ? ending(ended) : t("page-runs-cut-off"), `${seconds.toFixed(1)} s`];
  if (reached.length + missed > 0)
    facts.push(t("page-problems-goals-reached", { reached: reached.length, all: reached.length + missed }));
  if (robot && world)
    facts.push(t("page-project-on-in", { robot: project.robotTitle(robot), world: project.worldTitle(world) }));
  else if (robot) facts.push(project.robotTitle(robot));
  if (run.foreign) facts.push(t("page-runs-foreign"));
  return facts;
}

function Tools({ run, isReadOnly }: { run: KeptRun; isReadOnly: boolean }) {
  const { keptRuns, dialogs } = usePage();
  const { id, name = "", damaged = false } = run;
  const values = { name: runTitle(run) };
  // A name is work that would be lost.
  const remove = () => (name ? dialogs.show({ deleteRun: id }) : keptRuns.delete(id));
  return (
    <>
      <IconButton
        icon="rename"
        word="page-runs-name-of"
        values={values}
        off={damaged || isReadOnly}
        onClick={() => dialogs.show({ nameRun: id })}
      />
      <IconButton
        icon="download"
        word="page-runs-download"
        values={values}
        off={damaged}
        onClick={() => download(keptRuns.address(id))}
      />
      <IconButton icon="trash" word="page-runs-delete-of" values={values} off={isReadOnly} onClick={remove} />
    </>
  );
}

function download(address: string): void {
  const link = document.createElement("a");
  link.href = address;
  // The server names the file.
  link.download = "";
  link.click();
}
