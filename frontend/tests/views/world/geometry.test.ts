import { expect, test } from "vitest";

import type { LineValues } from "../../../src/views/world/scenery/description";
import {
  between,
  cornersOf,
  forward,
  from,
  headingOf,
  type Pose,
  radians,
  wrapped,
} from "../../../src/views/world/scenery/geometry";
import { numbers } from "../../random";

function line(values: Partial<LineValues>): LineValues {
  return { points: [], path: [], start: [0, 0, 0], closed: false, ...values } as unknown as LineValues;
}

test("heading 0 looks east and 90 looks south", () => {
  expect(forward(0)[0]).toBeCloseTo(1);
  expect(forward(90)[1]).toBeCloseTo(-1);
});

test("a heading is what its unit vector points to", () => {
  for (let heading = -179; heading < 180; heading++) expect(headingOf(...forward(heading))).toBeCloseTo(heading);
});

test("a wrapped heading is the same direction within half a turn", () => {
  const random = numbers(3);
  for (let round = 0; round < 500; round++) {
    const heading = (random() - 0.5) * 4000;
    expect(wrapped(heading)).toBeGreaterThanOrEqual(-180);
    expect(wrapped(heading)).toBeLessThan(180);
    expect(Math.cos(radians(wrapped(heading)))).toBeCloseTo(Math.cos(radians(heading)));
  }
});

test("driving ahead and back ends at the start", () => {
  const random = numbers(4);
  for (let round = 0; round < 200; round++) {
    const start: Pose = { x: random() * 100, y: random() * 100, heading: random() * 360 };
    const [x, y] = from(start, 50, 20);
    const [backX, backY] = from({ x, y, heading: start.heading }, -50, -20);
    expect(backX).toBeCloseTo(start.x);
    expect(backY).toBeCloseTo(start.y);
  }
});

test("left of a robot that looks east is north", () => {
  const [x, y] = from({ x: 0, y: 0, heading: 0 }, 0, 10);
  expect(x).toBeCloseTo(0);
  expect(y).toBeCloseTo(10);
});

test("a value outside its bounds becomes the nearest bound", () => {
  expect([between(-1, 0, 5), between(3, 0, 5), between(9, 0, 5)]).toEqual([0, 3, 5]);
});

test("a closed line ends at its first corner", () => {
  const points = [
    [0, 0],
    [100, 0],
    [100, 100],
  ] as LineValues["points"];
  expect(cornersOf(line({ points, closed: true })).at(-1)).toEqual([0, 0]);
  expect(cornersOf(line({ points }))).toEqual(points);
});

test("a path of four sides and corners comes back to its start", () => {
  const side = { forward: 100, turn: null, radius: null };
  const corner = { forward: null, turn: 90, radius: 20 };
  const path = Array.from({ length: 4 }, () => [side, corner]).flat();
  const [x, y] = cornersOf(line({ path, start: [7, 8, 30] })).at(-1) ?? [0, 0];
  expect(x).toBeCloseTo(7);
  expect(y).toBeCloseTo(8);
});

test("a curve keeps its radius from its centre", () => {
  const path = [{ forward: null, turn: 180, radius: 50 }];
  for (const [x, y] of cornersOf(line({ path }))) expect(Math.hypot(x, y + 50)).toBeCloseTo(50);
});
