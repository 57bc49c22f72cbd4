import { expect, test } from "vitest";

import { isBlinking } from "../../../src/views/world/robots/blinking";

/** When eyes are closed in a minute, in steps of 10 ms. */
const CLOSED = Array.from({ length: 6000 }, (_, i) => 10 * i).filter(isBlinking);

test("eyes are closed for a moment now and then", () => {
  const begins = CLOSED.filter((time) => !CLOSED.includes(time - 10));
  expect(begins.length).toBeGreaterThan(8);
  expect(begins.length).toBeLessThan(20);
  expect(CLOSED.length / begins.length).toBe(13);
});

test("eyes are open at first", () => {
  expect(isBlinking(0)).toBe(false);
});
