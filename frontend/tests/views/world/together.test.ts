import { PerspectiveCamera, Vector3 } from "three";
import { expect, test } from "vitest";

import { FIELD } from "../../../src/views/world/framing";
import type { XY } from "../../../src/views/world/scenery/description";
import { Together } from "../../../src/views/world/together";

const ASPECT = 16 / 9;

/** A camera that looks from the south at the middle of the floor, with pixels covered above and below. */
function camera(distance: number, covered = 0): PerspectiveCamera {
  const made = new PerspectiveCamera(FIELD, ASPECT, 20, 45_000);
  made.up.set(0, 0, 1);
  made.position.set(0, -0.8 * distance, 0.6 * distance);
  made.lookAt(0, 0, 0);
  if (covered) {
    const free = 900 - 2 * covered;
    made.aspect = 1600 / free;
    made.setViewOffset(1600, free, 0, -covered, 1600, 900);
  }
  made.updateProjectionMatrix();
  return made;
}

/** Step until it has arrived; return what it looks at. */
function settle(eye: PerspectiveCamera, places: readonly XY[], calm = false): { target: Vector3; steps: number } {
  const [together, target] = [new Together(eye), new Vector3()];
  let steps = 0;
  while (together.step(places, target, 20 * steps, calm) && steps < 500) steps += 1;
  eye.updateMatrixWorld();
  return { target, steps };
}

/** Where a place is in the picture, from its middle. */
function seen(eye: PerspectiveCamera, [x, y]: XY): number {
  const { x: right, y: up } = new Vector3(x, y, 0).project(eye);
  return Math.max(Math.abs(right), Math.abs(up));
}

test.each([
  [
    [-1000, 300],
    [-1000, -300],
  ],
  [
    [-2500, 0],
    [2500, 900],
  ],
  [
    [0, 0],
    [0, 4000],
  ],
  [
    [-4000, -4000],
    [4000, 4000],
  ],
] as [XY, XY][])("robots at %j and %j are both in the inner picture", (one, other) => {
  const eye = camera(1500);
  const { steps } = settle(eye, [one, other]);
  expect(steps).toBeLessThan(500);
  for (const place of [one, other]) expect(seen(eye, place)).toBeLessThan(0.8);
});

test("it stays where it is while all robots are in the picture and large enough", () => {
  const eye = camera(2400);
  const before = eye.position.clone();
  expect(
    settle(eye, [
      [-500, 0],
      [500, 0],
    ]).steps,
  ).toBe(0);
  expect(eye.position).toEqual(before);
});

test("it comes nearer when the robots meet, but not beyond its nearest place", () => {
  const eye = camera(9000);
  const { target } = settle(eye, [
    [10, 0],
    [-10, 0],
  ]);
  const distance = eye.position.distanceTo(target);
  expect(distance).toBeGreaterThan(650);
  expect(distance).toBeLessThan(2500);
});

test("who wants little motion gets one cut", () => {
  const eye = camera(1500);
  expect(
    settle(
      eye,
      [
        [-2000, 0],
        [2000, 0],
      ],
      true,
    ).steps,
  ).toBeLessThan(12);
  expect(seen(eye, [2000, 0])).toBeLessThan(0.8);
});

test("robots keep clear of what covers the edges of the picture", () => {
  const eye = camera(1500, 150);
  settle(eye, [
    [0, -1500],
    [0, 1500],
  ]);
  for (const place of [
    [0, -1500],
    [0, 1500],
  ] as XY[])
    expect(seen(eye, place)).toBeLessThan(0.67);
});
