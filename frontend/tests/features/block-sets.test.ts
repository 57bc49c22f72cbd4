import { expect, test } from "vitest";

import { forget, type Group, setOf, tick, ticksOf } from "../../src/features/block-sets/ticks";
import { shows } from "../../src/model/shown-blocks";
import type { BlockSet } from "../../src/protocol/messages";
import { numbers, pick } from "../random";

const GROUPS: readonly Group[] = [
  { category: "control", blocks: ["wait", "repeat"] },
  { category: "motor", blocks: ["turn", "stop", "drive"] },
  { category: "sensors", blocks: ["distance"] },
];
const BLOCKS = GROUPS.flatMap(({ category, blocks }) => blocks.map((block) => [category, block] as const));

test("ticking any blocks gives a set that shows exactly these", () => {
  const random = numbers(5);
  for (let round = 0; round < 200; round++) {
    const base: BlockSet = pick(random, [{ name: "all" }, { name: "few", show: { categories: ["motor"] } }]);
    // The dialog does not offer a set without a block.
    let ticks = tick(ticksOf(base, GROUPS), ["wait"], true);
    for (const [, block] of BLOCKS.slice(1)) ticks = tick(ticks, [block], random() < 0.5);
    const set = setOf({ base, ticks, changed: true }, GROUPS);
    for (const [category, block] of BLOCKS) expect(shows(set, category, block)).toBe(ticks.blocks.has(block));
  }
});

test("an unchanged set stays as it is", () => {
  const base: BlockSet = { name: "few", show: { blocks: ["turn", "unknown"] } };
  expect(setOf({ base, ticks: ticksOf(base, GROUPS), changed: false }, GROUPS)).toBe(base);
});

test("a whole tab is named as a tab", () => {
  const base: BlockSet = { name: "few", show: { blocks: ["turn"] } };
  const ticks = tick(ticksOf(base, GROUPS), ["stop", "drive"], true);
  expect(setOf({ base, ticks, changed: true }, GROUPS).show).toEqual({ categories: ["motor"], blocks: [] });
});

test("names that the palette lacks are kept until they are forgotten", () => {
  const base: BlockSet = { name: "few", show: { categories: ["gone"], blocks: ["turn", "unknown"] } };
  const ticks = ticksOf(base, GROUPS);
  expect(ticks.absent).toEqual({ categories: ["gone"], blocks: ["unknown"] });
  expect(forget(ticks, "unknown").absent).toEqual({ categories: ["gone"], blocks: [] });
});

test("a set that only hides shows blocks that come later", () => {
  expect(ticksOf({ name: "a", hide: { blocks: ["turn"] } }, GROUPS).later).toBe(true);
  expect(ticksOf({ name: "b", show: { blocks: ["turn"] } }, GROUPS).later).toBe(false);
});
