/** Where and why two runs parted. */

import { type Phrase, say, t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import type { ComparedRun } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { RunColour, titleOf } from "./legend";
import "./runs.css";

export function Comparison() {
  const page = usePage();
  const { keptRuns, dialogs } = page;
  const compared = keptRuns.compared.value;
  if (!compared) return null;
  const { first, second, together = null, because, causes = [] } = compared;
  return (
    <section class="comparison" aria-label={t("page-runs-compared")} data-selectable>
      <div class="comparison-head">
        <h3>
          <RunColour index={0} /> {titleOf(page, first.id)} · <RunColour index={1} /> {titleOf(page, second.id)}
        </h3>
        <IconButton icon="close" word="page-runs-compare-end" onClick={() => (keptRuns.compared.value = null)} />
      </div>
      <div aria-live="polite">
        <p>
          {together === null ? t("page-runs-same") : t("page-runs-together", { seconds: together.toFixed(2) })}{" "}
          {together !== null && because && <Moment run={first} phrase={say(because)} />}
        </p>
        {together !== null && !because && (
          <>
            <Did run={first} index={0} />
            <Did run={second} index={1} />
          </>
        )}
        {causes.length > 0 && (
          <ul>
            {causes.map((cause) => (
              <li key={JSON.stringify(cause)}>{say(named(page, cause))}</li>
            ))}
          </ul>
        )}
      </div>
      {because && (
        <p>
          <Moment run={first} phrase={t("page-runs-moment-first")} /> ·{" "}
          <Moment run={second} phrase={t("page-runs-moment-second")} />
        </p>
      )}
      <button
        type="button"
        class="button bordered"
        onClick={() => {
          keptRuns.readCalls();
          dialogs.show("callsBeside");
        }}
      >
        {t("page-calls-beside")}
      </button>
    </section>
  );
}

/** A cause with the titles of robots and worlds. */
function named({ project }: Page, cause: Phrase): Phrase {
  const title = TITLES[cause.code]?.(project);
  if (!title || !cause.values) return cause;
  const values = Object.entries(cause.values).map(([name, value]) => [name, title(String(value))]);
  return { ...cause, values: Object.fromEntries(values) };
}

const TITLES: Readonly<Record<string, (project: Page["project"]) => (name: string) => string>> = {
  "why-cause-robot": (project) => (name) => project.robotTitle(name),
  "why-cause-world": (project) => (name) => project.worldTitle(name),
  "why-cause-variant": (project) => (name) => project.worldTitle(name),
};

function Did({ run, index }: { run: ComparedRun; index: number }) {
  if (!run.step) return null;
  return (
    <p class="run-did">
      <RunColour index={index} />
      <Moment run={run} phrase={say(run.step.phrase)} />
    </p>
  );
}

/** Leads to the moment at which a run parted from the other one. */
function Moment({ run, phrase }: { run: ComparedRun; phrase: string }) {
  const { keptRuns } = usePage();
  return (
    <button
      type="button"
      class="text-link moment-link"
      onClick={() => run.step && keptRuns.lookAt(run.id, run.step.time)}
    >
      {phrase}
    </button>
  );
}
