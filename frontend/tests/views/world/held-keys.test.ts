import { expect, test } from "vitest";

import { describeKeys, type Key, keyOf } from "../../../src/views/world/held-keys";

const WANTED: readonly Key[] = ["up", "space", "enter", "w", "7"];

test("a pressed key is named as in programs", () => {
  const named = ["ArrowUp", " ", "Enter", "w", "7"].map((key) => keyOf({ key }, WANTED));
  expect(named).toEqual(WANTED);
});

test("a letter is the same key with Shift", () => {
  expect(keyOf({ key: "W" }, WANTED)).toBe("w");
});

test("keys that the program does not ask for stay with the page", () => {
  const named = ["ArrowDown", "o", "Escape", "Tab"].map((key) => keyOf({ key }, WANTED));
  expect(named).toEqual([undefined, undefined, undefined, undefined]);
});

test("the keys are shown as on the keyboard", () => {
  expect(describeKeys(["up", "left", "w", "7"])).toBe("↑ ← W 7");
});
