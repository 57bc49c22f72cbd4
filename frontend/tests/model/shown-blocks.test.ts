import { expect, test } from "vitest";

import { blocksOf, shownTabs, shows } from "../../src/model/shown-blocks";

test("a set that says nothing shows everything", () => {
  expect(shows({ name: "all" }, "control", "wait")).toBe(true);
});

test("a set that shows something shows nothing else", () => {
  const set = { name: "few", show: { categories: ["control"] } };
  expect([shows(set, "control", "wait"), shows(set, "motor", "turn")]).toEqual([true, false]);
});

test("what is said of a block outweighs what is said of its category", () => {
  expect(shows({ name: "a", show: { blocks: ["wait"] }, hide: { categories: ["control"] } }, "control", "wait")).toBe(
    true,
  );
  expect(shows({ name: "b", show: { categories: ["control"] }, hide: { blocks: ["wait"] } }, "control", "wait")).toBe(
    false,
  );
});

test("hiding a block outweighs showing it", () => {
  expect(shows({ name: "a", show: { blocks: ["wait"] }, hide: { blocks: ["wait"] } }, "control", "wait")).toBe(false);
});

test("a tab without a shown block is left out", () => {
  const tabs = [
    { category: "control", contents: [{ kind: "block", type: "wait" }] },
    { category: "motor", contents: [{ kind: "block", type: "turn" }] },
  ];
  const shown = shownTabs(tabs, { name: "a", hide: { blocks: ["turn"] } });
  expect(shown.map(({ category }) => category)).toEqual(["control"]);
});

test("a button in a shown tab is always shown", () => {
  const contents = [{ kind: "button" }, { kind: "block", type: "wait" }, { kind: "block", type: "stop" }];
  const [tab] = shownTabs([{ category: "control", contents }], { name: "a", hide: { blocks: ["stop"] } });
  expect(tab?.contents).toEqual(contents.slice(0, 2));
});

test("a tab that depends on the program has its known blocks", () => {
  expect(blocksOf({ custom: "WHEN" })).toContain("lb_when");
});
