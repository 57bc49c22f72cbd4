// @vitest-environment happy-dom

import { expect, test } from "vitest";

import { areaAround } from "../../src/features/hand-ins/way";
import type { WorldValues } from "../../src/views/world/scenery/description";

const hall = (...size: [number, number]) => ({ floor: { size } }) as unknown as WorldValues;

test("of a large floor only what is around the way is seen", () => {
  const way = [[0, 0], [200, 0], [200, 100]] as const; // biome-ignore format: one line is a way
  expect(areaAround(way, hall(3000, 3000))).toBe("-500 -550 1200 1200");
});

test("at an edge the floor fills the picture", () => {
  expect(areaAround([[1400, 1400]], hall(3000, 2800))).toBe("500 400 1000 1000");
});

test("a floor that is hardly larger is seen whole, as one on which nothing drove", () => {
  expect(areaAround([[0, 0], [900, 0]], hall(2000, 2000))).toBeUndefined(); // biome-ignore format: a way
  expect(areaAround([], hall(3000, 3000))).toBeUndefined();
});
