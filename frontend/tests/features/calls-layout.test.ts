import { expect, test } from "vitest";

import { lay } from "../../src/features/calls/layout";
import type { CallGraph } from "../../src/protocol/messages";

/** A graph of functions by layer, and of calls by index. */
function graph(layers: readonly number[], calls: readonly (readonly [number, number])[]): CallGraph {
  const none = { count: 1, seconds: 0, share: 0 };
  return {
    kind: "CallGraph",
    robot: "ebo",
    first: 0,
    last: 1,
    functions: layers.map((layer, index) => ({ layer, name: `f${index}`, ...none })),
    edges: calls.map(([caller, callee]) => ({ caller, callee, first: 0, event: 0, ...none })),
  };
}

test("functions of one layer are in one column, whatever calls them", () => {
  // The program calls a skill itself, and another one through a function.
  const { places, columns } = lay(
    graph(
      [0, 1, 2, 2, 4],
      [
        [0, 1],
        [0, 2],
        [1, 3],
        [2, 4],
        [3, 4],
      ],
    ),
  );
  expect(places[2]?.x).toBeCloseTo(places[3]?.x ?? 0);
  expect(columns.map(({ layer }) => layer)).toEqual([0, 1, 2, 4]);
  const xs = columns.map(({ x }) => x);
  expect(xs).toEqual([...xs].sort((a, b) => a - b));
});

test("functions that call one another are beside each other, before the next layer", () => {
  const { places } = lay(
    graph(
      [0, 1, 1, 2],
      [
        [0, 1],
        [1, 2],
        [2, 1],
        [2, 2],
        [1, 3],
        [2, 3],
      ],
    ),
  );
  const xs = places.map(({ x }) => x);
  expect(xs).toEqual([...xs].sort((a, b) => a - b));
  expect(new Set(xs).size).toBe(4);
});

test("in a narrow panel each layer has a row below what calls it, and nothing is beside the panel", () => {
  const calls = graph(
    [0, 1, 2, 3, 4, 5],
    [
      [0, 1],
      [1, 2],
      [2, 3],
      [3, 4],
      [4, 5],
    ],
  );
  const { places, columns, width } = lay(calls, 534);
  expect(width).toBeLessThanOrEqual(534);
  const ys = places.map(({ y }) => y);
  expect(ys).toEqual([...ys].sort((a, b) => a - b));
  expect(columns.map(({ isRow }) => isRow)).toEqual(Array(6).fill(true));
  expect(lay(calls).width).toBeGreaterThan(534);
});
