/** Which way in the world is that of which run, while two are compared. */

import { t } from "../../i18n";
import { RUN_COLOURS } from "../../model/kept-runs";
import { type Page, usePage } from "../../model/page";
import { runTitle } from "../../model/run-title";
import "./runs.css";

export function Legend() {
  const page = usePage();
  const compared = page.keptRuns.compared.value;
  if (!compared) return null;
  return (
    <ul class="status run-legend" aria-label={t("page-runs-legend")}>
      {[compared.first.id, compared.second.id].map((id, index) => (
        <li key={id} class="chip">
          <RunColour index={index} />
          {titleOf(page, id)}
        </li>
      ))}
    </ul>
  );
}

/** The line of a run in the world; the second one is thinner. */
export function RunColour({ index }: { index: number }) {
  return <span class={index ? "run-colour second" : "run-colour"} style={{ "--run": RUN_COLOURS[index] }} />;
}

export function titleOf({ keptRuns }: Page, id: string): string {
  const run = keptRuns.runs.value?.find((one) => one.id === id);
  return run ? runTitle(run) : "";
}
