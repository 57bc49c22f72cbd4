import { expect, test } from "vitest";

import { day } from "../../src/ui/dates";

const NOON = new Date(2026, 4, 13, 12);

function secondsOf(...when: [number, number, number, number]): number {
  return new Date(...when).getTime() / 1000;
}

test("a day is named as people do", () => {
  expect(day(secondsOf(2026, 4, 13, 0), NOON)).toBe("today");
  expect(day(secondsOf(2026, 4, 12, 23), NOON)).toBe("yesterday");
  expect(day(secondsOf(2026, 4, 11, 23), NOON)).toBe("May 11");
  expect(day(secondsOf(2025, 11, 24, 8), NOON)).toBe("December 24, 2025");
});

test("a time that a wrong clock has put into the future is a date", () => {
  expect(day(secondsOf(2026, 4, 14, 1), NOON)).toBe("May 14");
});
