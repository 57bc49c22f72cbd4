import { expect, test } from "vitest";

import { scaleFor } from "../../../src/views/blocks/fit";

test("a program that has room has its usual size", () => {
  expect(scaleFor([200, 200], [390, 360], 0.85)).toBe(0.85);
});

test("a program that is too high or too wide is smaller", () => {
  expect(scaleFor([200, 480], [390, 360], 0.85)).toBe(0.75);
  expect(scaleFor([520, 200], [390, 360], 0.85)).toBe(0.75);
});

test("a long program is cut before its words can't be read", () => {
  expect(scaleFor([390, 2000], [390, 360], 0.85)).toBe(0.68);
});
