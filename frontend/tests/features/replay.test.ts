// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { Replay } from "../../src/features/replay/replay";
import type { Share } from "../../src/features/share/share";
import type { Page } from "../../src/model/page";

let past: ReturnType<typeof signal<object | null>>;
let looks: number[];
let circles: boolean[];
let films: string[];
let replay: Replay;

/** A page whose last run took so many seconds; every look back is answered at once. */
function show(end: number): void {
  past = signal<object | null>(null);
  [looks, circles, films] = [[], [], []];
  const running = { past, timeline: signal({ end }) };
  const look = (time: number) => {
    looks.push(Math.round(10 * time) / 10);
    past.value = {};
  };
  const world = signal({ circle: (on: boolean) => circles.push(on) });
  const record = (over: () => void) => ({
    end: () => films.push("saved") && over(),
    drop: () => films.push("dropped") && over(),
  });
  const page = {
    context: { running },
    lookingBack: { look, leave: () => (past.value = null) },
    views: { world },
    share: { record },
  };
  replay = new Replay(page as unknown as Page & { share: Share });
}

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

test("the last ten seconds come at their own speed, and then the end as before", () => {
  show(25);
  replay.watch();
  vi.advanceTimersByTime(5000);
  expect([looks[0], looks.at(-1), circles]).toEqual([15, 20, [true]]);
  vi.advanceTimersByTime(6000);
  expect([looks.at(-1), past.value, replay.isShown.value, circles]).toEqual([25, null, false, [true, false]]);
  const count = looks.length;
  vi.advanceTimersByTime(5000);
  expect(looks.length).toBe(count);
});

test("a shorter run is shown whole", () => {
  show(4);
  replay.watch();
  expect([looks[0], replay.seconds.value]).toEqual([0, 4]);
});

test("a film begins with the first of the seconds, and is saved at the end", () => {
  show(25);
  replay.watch();
  vi.advanceTimersByTime(3000);
  replay.save();
  expect(looks.at(-1)).toBe(15);
  vi.advanceTimersByTime(10_000);
  expect(films).toEqual([]);
  vi.advanceTimersByTime(1000);
  expect([films, replay.isShown.value]).toEqual([["saved"], false]);
});

test("who goes back to now, or runs again, ends it without a film", () => {
  show(25);
  replay.save();
  vi.advanceTimersByTime(1000);
  past.value = null;
  expect([films, replay.isShown.value, circles]).toEqual([["dropped"], false, [true, false]]);
  vi.advanceTimersByTime(20_000);
  expect(past.value).toBe(null);
});
