// @vitest-environment happy-dom

import { expect, test } from "vitest";

import { hear, isHeard, loudness } from "../../src/model/loudness";
import { prefer } from "../../src/model/preferences";

test("a robot is heard at home, and in a class only once its pupil wants it", () => {
  expect([isHeard(false), isHeard(true)]).toEqual([true, false]);
  prefer(hear(true, true));
  expect(isHeard(true)).toBe(true);
  prefer(hear(false, false));
  expect([isHeard(false), isHeard(true)]).toEqual([false, true]);
});

test.each([
  [0, 0],
  [50, 1],
  [100, 2],
])("a volume of %i makes it %i times as loud as usual", (volume, times) => {
  prefer({ volume });
  expect(loudness()).toBe(times);
});
