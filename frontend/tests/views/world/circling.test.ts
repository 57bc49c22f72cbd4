import { PerspectiveCamera, Vector3 } from "three";
import { expect, test } from "vitest";

import { Circling } from "../../../src/views/world/circling";
import type { XY } from "../../../src/views/world/scenery/description";

const FAR_APART: XY[] = [
  [-1500, 0],
  [1500, 0],
];

function camera(): PerspectiveCamera {
  const made = new PerspectiveCamera(40, 1.5, 20, 45_000);
  made.up.set(0, 0, 1);
  return made;
}

/** Where places are in the picture of a camera, from -1 to 1. */
function seen(made: PerspectiveCamera, places: readonly XY[]): Vector3[] {
  made.updateMatrixWorld();
  return places.map(([x, y]) => new Vector3(x, y, 0).project(made));
}

test("it looks at the robot at once, and goes round it", () => {
  const [made, target] = [camera(), new Vector3()];
  const circling = new Circling(made);
  circling.step([[400, -200]], target, 0, false);
  const first = made.position.clone();
  for (let now = 16; now < 4000; now += 16) circling.step([[400, -200]], target, now, false);
  expect(target.toArray()).toEqual([400, -200, 0]);
  expect(first.distanceTo(made.position)).toBeGreaterThan(300);
  const [place] = seen(made, [[400, -200]]);
  expect(Math.hypot(place!.x, place!.y)).toBeLessThan(0.01);
});

test("robots that are far apart are all in the picture", () => {
  const [made, target] = [camera(), new Vector3()];
  const circling = new Circling(made);
  for (let now = 0; now < 10_000; now += 50) {
    circling.step(FAR_APART, target, now, false);
    for (const { x, y } of seen(made, FAR_APART)) expect(Math.max(Math.abs(x), Math.abs(y))).toBeLessThan(1);
  }
});

test("who wants little motion sees it from one side", () => {
  const [made, target] = [camera(), new Vector3()];
  const circling = new Circling(made);
  circling.step([[0, 0]], target, 0, true);
  const first = made.position.clone();
  circling.step([[0, 0]], target, 5000, true);
  expect(made.position.distanceTo(first)).toBeLessThan(0.001);
});
