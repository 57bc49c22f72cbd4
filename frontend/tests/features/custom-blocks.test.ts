import { expect, test } from "vitest";

import { type Argument, parseValue } from "../../src/features/custom-blocks/arguments";
import {
  blocksIn,
  languagesOf,
  withBlock,
  withVariable,
  withWord,
} from "../../src/features/custom-blocks/configuration";

const CONFIGURATION = JSON.stringify([
  { type: "motor", category: "my", name: "spin", extra: 1, variables: [{ name: "times", type: "number" }] },
  { type: "motor", category: "my", name: "hop" },
]);

test("configurations that are not blocks give none", () => {
  expect(["{", "3", "null", '[{"type": "motor"}]'].map(blocksIn)).toEqual([[], [], [], []]);
});

test("changing one block leaves the others and unknown keys alone", () => {
  const changed = JSON.parse(withBlock(CONFIGURATION, "spin", (block) => ({ ...block, category: "new" })));
  expect(changed[0]).toMatchObject({ category: "new", extra: 1 });
  expect(changed[1]).toEqual(JSON.parse(CONFIGURATION)[1]);
});

test("a change that changes nothing keeps the configuration's value", () => {
  expect(JSON.parse(withBlock(CONFIGURATION, "spin", (block) => block))).toEqual(JSON.parse(CONFIGURATION));
});

test("an empty word is removed", () => {
  expect(withWord(withWord({ EN: "spin" }, "ES", "gira"), "ES", "")).toEqual({ EN: "spin" });
});

test("only the parameter of that name changes", () => {
  const [block] = blocksIn(CONFIGURATION);
  const changed = withVariable(block as never, "times", (one) => ({ ...one, default: 3 }));
  expect(changed.variables).toEqual([{ name: "times", type: "number", default: 3 }]);
});

test("a block's languages and the page's are listed once each", () => {
  const [block] = blocksIn(CONFIGURATION);
  expect(languagesOf({ ...block, languages: { EN: "spin", FR: "tourne" } } as never, ["EN", "ES"])).toEqual([
    "EN",
    "ES",
    "FR",
  ]);
});

test.each<[Argument["kind"], string, unknown]>([
  ["number", "1.5", 1.5],
  ["number", "", undefined],
  ["range", "fast", undefined],
  ["tag", "8", 8],
  ["tag", "door", "door"],
  ["truth", "TRUE", true],
  ["truth", "FALSE", false],
  ["list", "[1, 2]", [1, 2]],
  ["list", "{}", undefined],
  ["list", "[1", undefined],
  ["text", "8", "8"],
])("%s written as %o means %o", (kind, written, value) => {
  expect(parseValue({ name: "a", kind, allowed: {}, initial: "" }, written)).toEqual(value);
});
