/** Where the functions of a call graph are drawn: each layer has a column, to the right of what calls it, or a row. */

import { Graph, layout } from "@dagrejs/dagre";

import type { CallGraph } from "../../protocol/messages";
import { BOX, type Column, type Laid, type Place } from "./places";

/** Pixels. */
const GAPS = { nodesep: 12, ranksep: 52, edgesep: 8 };

/** Lay a graph out from left to right, or from top to bottom if the room, in pixels, is too narrow for that. */
export function lay(graph: CallGraph, room = Infinity): Laid {
  const across = laidOut(graph, "LR");
  if (across.width <= room) return across;
  const down = laidOut(graph, "TB");
  return down.width < across.width ? down : across;
}

function laidOut(graph: CallGraph, rankdir: "LR" | "TB"): Laid {
  const { functions = [], edges = [] } = graph;
  const drawn = new Graph({ multigraph: true });
  drawn.setGraph({ rankdir, ...GAPS, marginx: 8, marginy: 8 });
  functions.forEach((_, index) => drawn.setNode(`${index}`, { ...BOX }));
  const ranks = ranked(graph);
  edges.forEach(({ caller, callee }, index) => {
    const minlen = (ranks[callee] ?? 0) - (ranks[caller] ?? 0);
    if (minlen > 0) drawn.setEdge(`${caller}`, `${callee}`, { minlen }, `${index}`);
  });
  layout(drawn);
  const places = functions.map((_, index) => at(drawn.node(`${index}`)));
  const lines = edges.map(({ caller, callee }, index) =>
    drawn.hasEdge(`${caller}`, `${callee}`, `${index}`)
      ? (drawn.edge(`${caller}`, `${callee}`, `${index}`).points ?? []).map(at)
      : arc(places[caller], places[callee]),
  );
  const { width = 0, height = 0 } = drawn.graph();
  return { width, height, places, lines, columns: rankdir === "LR" ? columns(graph, places) : rows(graph, places) };
}

/**
 * How far to the right each function is. A layer whose functions call one another takes several
 * places; a call of a function by itself, or by what it has called, leads back.
 */
function ranked({ functions = [], edges = [] }: CallGraph): number[] {
  const depths = functions.map(() => 0);
  const inOrder = [...edges].sort((a, b) => a.caller - b.caller);
  for (const { caller, callee } of inOrder) {
    const isInside = functions[caller]?.layer === functions[callee]?.layer && caller < callee;
    if (isInside) depths[callee] = Math.max(depths[callee] ?? 0, (depths[caller] ?? 0) + 1);
  }
  const layers = [...new Set(functions.map(({ layer }) => layer))].sort((a, b) => a - b);
  const starts = new Map<number, number>();
  let next = 0;
  for (const layer of layers) {
    starts.set(layer, next);
    next += 1 + Math.max(...depths.filter((_, index) => functions[index]?.layer === layer));
  }
  return functions.map(({ layer }, index) => (starts.get(layer) ?? 0) + (depths[index] ?? 0));
}

/** The names of the layers above their columns. */
function columns({ functions = [] }: CallGraph, places: readonly Place[]): Column[] {
  const layers = [...new Set(functions.map(({ layer }) => layer))];
  return layers.map((layer) => {
    const xs = places.filter((_, index) => functions[index]?.layer === layer).map(({ x }) => x);
    return { layer, x: (Math.min(...xs) + Math.max(...xs)) / 2, y: -4 };
  });
}

/** The names of the layers at the beginning of their rows. */
function rows({ functions = [] }: CallGraph, places: readonly Place[]): Column[] {
  const layers = [...new Set(functions.map(({ layer }) => layer))];
  return layers.map((layer) => {
    const ys = places.filter((_, index) => functions[index]?.layer === layer).map(({ y }) => y);
    return { layer, x: 4, y: Math.min(...ys) - BOX.height / 2 - 6, isRow: true };
  });
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
