import { expect, test } from "vitest";

import { colourOf, partsOf } from "../../../src/views/blocks/colours";

test("three numbers are a colour, and the colour is the three numbers", () => {
  expect(colourOf([255, 136, 0])).toBe("#ff8800");
  expect(partsOf("#ff8800")).toEqual([255, 136, 0]);
});

test("numbers out of range are shown as the nearest colour", () => {
  expect(colourOf([300, -5, 12.4])).toBe("#ff000c");
});

test("a number that is not known leaves the colour open", () => {
  expect(colourOf([1, null, 3])).toBeNull();
});
