import { expect, test } from "vitest";

import { soundNamed } from "../../../src/views/output/melodies";

test("an effect is its tones one after the other", () => {
  const [first, second, ...others] = soundNamed("coin", 0.2);
  expect(others).toEqual([]);
  expect(first).toEqual({ hertz: 988, seconds: 0.08, volume: 0.2, delay: 0 });
  expect(second).toEqual({ hertz: 1319, seconds: 0.26, volume: 0.2, delay: 0.08 });
});

test("a note is one tone, and any other name has a tune of its own, always the same", () => {
  expect(soundNamed("Do", 0.2).map(({ hertz }) => hertz)).toEqual([261.63]);
  expect(soundNamed("hello", 0.2)).toEqual(soundNamed("hello", 0.2));
  expect(soundNamed("toString", 0.2)).toHaveLength(4);
});
