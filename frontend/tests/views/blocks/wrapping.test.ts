import { expect, test, vi } from "vitest";

vi.mock("blockly/core", () => ({}));
vi.mock("../../../src/views/blocks/optional", () => ({ arrangeOptional: () => undefined }));
const { lineStarts } = await import("../../../src/views/blocks/wrapping");

const word = (width: number) => ({ width, begins: true });
const value = (width: number) => ({ width, begins: false });

test("a sentence that fits has one line", () => {
  expect(lineStarts([word(100), value(42), word(42)], 200)).toEqual([]);
});

test("words that do not fit begin a line", () => {
  expect(lineStarts([word(100), word(80), word(50), word(180)], 200)).toEqual([2, 3]);
});

test("a value stays with the words before it", () => {
  expect(lineStarts([word(100), word(60), value(40)], 200)).toEqual([1]);
});

test("a value begins a line if no words can", () => {
  expect(lineStarts([word(180), value(40)], 200)).toEqual([1]);
});

test("a unit and the button that shows more take their value along to the next line", () => {
  const unit = { width: 30, begins: false, follows: true };
  expect(lineStarts([word(120), value(40), unit, unit], 200)).toEqual([1]);
  expect(lineStarts([word(60), value(60), value(40), unit, unit], 210)).toEqual([2]);
});

test("a unit begins a line if nothing else can", () => {
  const unit = { width: 150, begins: false, follows: true };
  expect(lineStarts([word(100), unit], 200)).toEqual([1]);
});
