import { expect, test } from "vitest";

import { lay } from "../../src/features/calls/layout";
import { layoutOf, merge, onlyIn } from "../../src/features/calls/merged";
import type { CallGraph } from "../../src/protocol/messages";

const NAMES: readonly (readonly [number, string])[] = [
  [0, "square"],
  [2, "turn"],
  [4, "Base.move"],
];

function graph(robot: string, ...drivers: string[]): CallGraph {
  const all = [...NAMES, ...drivers.map((name) => [5, name] as const)];
  return {
    kind: "CallGraph",
    robot,
    first: 0,
    last: 1,
    functions: all.map(([layer, name]) => ({ layer, name, count: 1, seconds: 0, share: 0 })),
    edges: all.slice(1).map((_, index) => ({
      caller: Math.min(index, 2),
      callee: index + 1,
      count: 1,
      seconds: 0,
      share: 0,
      first: 0,
      event: 0,
    })),
  };
}

const merged = merge(graph("ebo", "Ebo.drive"), graph("ev3", "Ev3.brake", "Ev3.drive"));
const [first, second] = merged.parts;

test("a function of both runs is once in the merged graph", () => {
  const names = (merged.graph.functions ?? []).map(({ name }) => name);
  expect(names).toEqual(["square", "turn", "Base.move", "Ebo.drive", "Ev3.brake", "Ev3.drive"]);
  expect(merged.graph.edges).toHaveLength(5);
});

test("only what one run has called is marked", () => {
  expect([...onlyIn(first, second)]).toEqual([3]);
  expect([...onlyIn(second, first)]).toEqual([3, 4]);
});

test("a function has the same place in both, and each of its lines ends there", () => {
  const laid = lay(merged.graph);
  const [one, other] = [layoutOf(first, laid), layoutOf(second, laid)];
  expect(one.places.slice(0, 3)).toEqual(other.places.slice(0, 3));
  expect(other.places).toHaveLength(5);
  expect(other.lines).toHaveLength(4);
  expect(other.lines[3]?.at(-1)?.y).toBeCloseTo(other.places[4]?.y ?? 0);
});
