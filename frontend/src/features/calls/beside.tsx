/** What called what in two runs, side by side: of one program on two robots, only the lowest rows differ. */

import { useMemo } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { runTitle } from "../../model/run-title";
import type { CallEdge } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { RunColour } from "../runs/legend";
import { LAYERS, Picture, useLaid } from "./calls";
import { layoutOf, type Merged, merge, onlyIn } from "./merged";

export function CallsBesideDialog() {
  const { dialogs, keptRuns } = usePage();
  const beside = keptRuns.beside.value;
  const merged = useMemo(() => (beside ? merge(beside.first, beside.second) : null), [beside]);
  return (
    <Dialog title={t("page-calls-beside")} close={() => dialogs.close()} size="whole">
      {merged && <Beside merged={merged} />}
    </Dialog>
  );
}

function Beside({ merged }: { merged: Merged }) {
  const { dialogs, keptRuns, project } = usePage();
  const laid = useLaid(merged.graph);
  const compared = keptRuns.compared.value;
  if (!laid || !compared) return null;
  const [first, second] = merged.parts;
  const marks = [onlyIn(first, second), onlyIn(second, first)];
  const differing = LAYERS.filter((_, layer) =>
    merged.parts.some(({ graph }, part) =>
      (graph.functions ?? []).some((one, index) => one.layer === layer && marks[part]?.has(index)),
    ),
  );
  const look = (run: string, { first, event }: CallEdge) => {
    dialogs.close();
    keptRuns.lookAt(run, first, event);
  };
  return (
    <>
      <p>
        {differing.length
          ? t("calls-differ", { layers: differing.map((layer) => t(layer)).join(", ") })
          : t("calls-alike")}
      </p>
      <div class="calls-beside">
        {[compared.first.id, compared.second.id].map((id, index) => {
          const part = index ? second : first;
          const run = keptRuns.runs.value?.find((one) => one.id === id);
          return (
            <section key={id} aria-label={run && runTitle(run)}>
              <h3>
                <RunColour index={index} /> {run && runTitle(run)} · {project.robotTitle(part.graph.robot)}
              </h3>
              <Picture
                graph={part.graph}
                laid={layoutOf(part, laid)}
                marked={marks[index]}
                look={(call) => look(id, call)}
              />
            </section>
          );
        })}
      </div>
    </>
  );
}
