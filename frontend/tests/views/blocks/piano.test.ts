import { expect, test } from "vitest";

import { areNotes, pitch } from "../../../src/views/blocks/fields/piano";

test("a sharp and the flat above it are the same key of the piano", () => {
  expect(pitch("C#4")).toBe(pitch("Db4"));
  expect(pitch("C4") - pitch("B3")).toBe(1);
  expect(pitch("A5") - pitch("A4")).toBe(12);
});

test("only a menu of notes is a piano", () => {
  expect(areNotes(["C4", "F#5", "Bb3"])).toBe(true);
  expect(areNotes(["C4", "red"])).toBe(false);
  expect(areNotes([])).toBe(false);
});
