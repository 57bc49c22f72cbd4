import { expect, it, vi } from "vitest";
import { QUALITIES, Qualities } from "../../../src/views/world/quality";

function drive(qualities: Qualities, every: number, seconds: number): void {
  for (let now = 0; now < seconds * 1000; now += every) qualities.note(now, true);
}

it("slow frames lower the quality step by step", () => {
  const apply = vi.fn();
  drive(new Qualities(0, apply), 60, 60);
  expect(apply.mock.calls.map(([quality]) => quality)).toEqual(QUALITIES);
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
