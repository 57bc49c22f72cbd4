/** Where the functions of a call graph are drawn: what calls is to the left of what it calls. */

import { Graph, layout } from "@dagrejs/dagre";

import type { CallGraph } from "../../protocol/messages";
import { BOX, type Laid, type Place } from "./places";

/** Pixels. */
const GAPS = { nodesep: 12, ranksep: 44, edgesep: 8 };

/** Lay a graph out from left to right. */
export function lay(graph: CallGraph): Laid {
  const { functions = [], edges = [] } = graph;
  const drawn = new Graph({ multigraph: true });
  drawn.setGraph({ rankdir: "LR", ...GAPS, marginx: 8, marginy: 8 });
  functions.forEach((_, index) => drawn.setNode(`${index}`, { ...BOX }));
  edges.forEach(({ caller, callee }, index) => {
    if (forwards(graph, caller, callee)) drawn.setEdge(`${caller}`, `${callee}`, {}, `${index}`);
  });
  layout(drawn);
  const places = functions.map((_, index) => at(drawn.node(`${index}`)));
  const lines = edges.map(({ caller, callee }, index) =>
    forwards(graph, caller, callee)
      ? (drawn.edge(`${caller}`, `${callee}`, `${index}`).points ?? []).map(at)
      : arc(places[caller], places[callee]),
  );
  const { width = 0, height = 0 } = drawn.graph();
  return { width, height, places, lines };
}

/** Whether a call leads to the right: not one of a function that calls itself, or what has called it. */
function forwards({ functions = [] }: CallGraph, caller: number, callee: number): boolean {
  const [from, to] = [functions[caller]?.layer ?? 0, functions[callee]?.layer ?? 0];
  return from < to || (from === to && caller < callee);
}

/** The line of a call back, such as of the function itself: over the boxes. */
function arc(from: Place | undefined, to: Place | undefined): Place[] {
  if (!from || !to) return [];
  const top = Math.min(from.y, to.y) - BOX.height * 0.8;
  return [
    { x: from.x + BOX.width / 4, y: from.y - BOX.height / 2 },
    { x: (from.x + to.x) / 2, y: top },
    { x: to.x - BOX.width / 4, y: to.y - BOX.height / 2 },
  ];
}

function at({ x = 0, y = 0 }: Partial<Place>): Place {
  return { x, y };
}
