import { expect, it, vi } from "vitest";
import { QUALITIES, Qualities } from "../../../src/views/world/quality";

function drive(qualities: Qualities, every: number, seconds: number): void {
  for (let now = 0; now < seconds * 1000; now += every) qualities.note(now, true);
}

it("no step shows its pixels: a slower computer draws fewer frames", () => {
  expect(Math.min(...QUALITIES.map(({ sharpness }) => sharpness))).toBe(0.75);
  expect(QUALITIES.at(-1)?.pace).toBeGreaterThan(100);
});

it("the picture keeps all its pixels down to twelve frames a second", () => {
  const coarse = QUALITIES.filter(({ sharpness }) => sharpness < 1);
  expect(Math.min(...coarse.map(({ pace }) => pace))).toBeGreaterThanOrEqual(80);
  expect(QUALITIES.filter(({ sharpness, pace }) => sharpness === 1 && pace > 0).map(({ pace }) => pace)).toEqual([
    30, 50, 80,
  ]);
});

it("a step that waits between frames is not too slow for that", () => {
  const apply = vi.fn();
  const step = QUALITIES.findIndex(({ pace }) => pace === 50);
  drive(new Qualities(step, apply), 52, 60);
  expect(apply).toHaveBeenCalledTimes(1);
});

it("slow frames lower the quality step by step", () => {
  const apply = vi.fn();
  drive(new Qualities(0, apply), 140, 120);
  expect(apply.mock.calls.map(([quality]) => quality)).toEqual(QUALITIES);
});

it("the slower the frames, the sooner the quality is lowered", () => {
  const stepsIn = (seconds: number, every: number) => {
    const apply = vi.fn();
    drive(new Qualities(0, apply), every, seconds);
    return apply.mock.calls.length - 1;
  };
  expect(stepsIn(3, 36)).toBe(1);
  expect(stepsIn(3, 60)).toBe(3);
});

it("fast frames keep the best quality", () => {
  const apply = vi.fn();
  drive(new Qualities(0, apply), 25, 60);
  expect(apply).toHaveBeenCalledTimes(1);
});

it("pauses between frames are not slow frames", () => {
  const apply = vi.fn();
  drive(new Qualities(0, apply), 500, 60);
  expect(apply).toHaveBeenCalledTimes(1);
});

it("each long pause raises a lowered quality by one step, up to the first one", () => {
  const apply = vi.fn();
  const qualities = new Qualities(2, apply);
  drive(qualities, 60, 6);
  const lowest = QUALITIES.indexOf(apply.mock.lastCall?.[0]);
  expect(lowest).toBeGreaterThan(3);

  for (let pause = 1; pause < 20; pause++) qualities.note(6000 + 4000 * pause, false);

  expect(apply.mock.lastCall?.[0]).toBe(QUALITIES[2]);
});

it("a better quality that is too slow is left at once", () => {
  const apply = vi.fn();
  const qualities = new Qualities(0, apply);
  drive(qualities, 140, 60);
  const lowest = apply.mock.lastCall?.[0];
  qualities.note(61_000, false);
  apply.mockClear();

  for (let i = 0; i < 20; i++) qualities.note(70_000 + 140 * i, true);

  expect(apply).toHaveBeenCalledTimes(2);
  expect(apply.mock.lastCall?.[0]).toBe(lowest);
});

it("a picture that comes late while something moves raises no quality", () => {
  const apply = vi.fn();
  const qualities = new Qualities(0, apply);
  drive(qualities, 60, 6);
  apply.mockClear();

  qualities.note(9000, true);

  expect(apply).not.toHaveBeenCalled();
});
