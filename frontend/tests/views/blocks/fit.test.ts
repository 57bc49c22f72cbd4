import { expect, test } from "vitest";

import { scaleFor } from "../../../src/views/blocks/fit";

test("a program that has room has its usual size", () => {
  expect(scaleFor([200, 200], [390, 360], 0.85)).toBe(0.85);
});

test("a program that is too high or too wide is smaller", () => {
  expect(scaleFor([200, 450], [390, 360], 0.85)).toBe(0.8);
  expect(scaleFor([487.5, 200], [390, 360], 0.85)).toBe(0.8);
});

test("a long program is cut before its words can't be read", () => {
  expect(scaleFor([390, 2000], [390, 360], 0.85)).toBe(0.75);
});
