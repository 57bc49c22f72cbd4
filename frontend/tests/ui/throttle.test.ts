import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { Throttle } from "../../src/ui/throttle";

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("window", globalThis);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("the first action is done at once and the last of the rest after the period", () => {
  const throttle = new Throttle(100);
  const done: number[] = [];
  for (const number of [1, 2, 3]) throttle.do(() => done.push(number));
  expect(done).toEqual([1]);
  vi.advanceTimersByTime(100);
  expect(done).toEqual([1, 3]);
});

test("no two actions are closer than the period", () => {
  const throttle = new Throttle(100);
  const times: number[] = [];
  for (let step = 0; step < 50; step++) {
    throttle.do(() => times.push(Date.now()));
    vi.advanceTimersByTime(30);
  }
  const gaps = times.slice(1).map((time, at) => time - (times[at] as number));
  expect(gaps.length).toBeGreaterThan(5);
  expect(Math.min(...gaps)).toBeGreaterThanOrEqual(100);
});

test("nothing is done after cancelling", () => {
  const throttle = new Throttle(100);
  const action = vi.fn();
  throttle.do(() => undefined);
  throttle.do(action);
  throttle.cancel();
  vi.runAllTimers();
  expect(action).not.toHaveBeenCalled();
});
