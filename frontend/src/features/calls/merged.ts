/** Two call graphs side by side: every function has the same place in both. */

import type { CallEdge, CallGraph } from "../../protocol/messages";
import type { Laid } from "./places";

/** A graph, and where its functions and edges are in the merged one. */
interface Part {
  readonly graph: CallGraph;
  readonly functions: readonly number[];
  readonly edges: readonly number[];
}

export interface Merged {
  readonly graph: CallGraph;
  readonly parts: readonly [Part, Part];
}

/** Both graphs in one. */
export function merge(first: CallGraph, second: CallGraph): Merged {
  const functions = [...(first.functions ?? [])];
  const edges = [...(first.edges ?? [])];
  const places = new Map(functions.map((one, index) => [`${one.layer} ${one.name}`, index]));
  const inMerged = (second.functions ?? []).map((one) => {
    const key = `${one.layer} ${one.name}`;
    const index = places.get(key) ?? functions.push(one) - 1;
    places.set(key, index);
    return index;
  });
  const lines = new Map(edges.map((edge, index) => [keyOf(edge), index]));
  const edgesInMerged = (second.edges ?? []).map((edge) => {
    const moved = { ...edge, caller: inMerged[edge.caller] ?? 0, callee: inMerged[edge.callee] ?? 0 };
    const index = lines.get(keyOf(moved)) ?? edges.push(moved) - 1;
    lines.set(keyOf(moved), index);
    return index;
  });
  const own = (items: readonly unknown[] | undefined) => (items ?? []).map((_, index) => index);
  return {
    graph: { ...first, functions, edges },
    parts: [
      { graph: first, functions: own(first.functions), edges: own(first.edges) },
      { graph: second, functions: inMerged, edges: edgesInMerged },
    ],
  };
}

/** The layout of one of the graphs in that of the merged one. */
export function layoutOf({ functions, edges }: Part, laid: Laid): Laid {
  return {
    ...laid,
    places: functions.map((index) => laid.places[index] ?? { x: 0, y: 0 }),
    lines: edges.map((index) => laid.lines[index] ?? []),
  };
}

/** The functions, by their index, that only this one of the graphs has. */
export function onlyIn(part: Part, other: Part): ReadonlySet<number> {
  const there = new Set(other.functions);
  return new Set(part.functions.flatMap((place, index) => (there.has(place) ? [] : [index])));
}

function keyOf({ caller, callee }: CallEdge): string {
  return `${caller} ${callee}`;
}
