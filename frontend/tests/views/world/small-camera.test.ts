import { expect, test } from "vitest";

import { areasOf, cameraOver } from "../../../src/views/world/small/camera";
import { emptyWorld } from "../../worlds";

const ASPECT = 1.47;

test.each([
  [{ west: -100, east: 100, south: -100, north: 100 }],
  [{ west: 300, east: 900, south: -2000, north: -1900 }],
  [{ west: -1000, east: 1000, south: -3000, north: 3000 }],
])("an area fills the picture and is whole in it: %o", (area) => {
  const camera = cameraOver(area, ASPECT);
  const corners = [area.south, area.north].flatMap((y) => [area.west, area.east].map((x) => camera.see(x, y)));
  expect(corners.every(({ right, up }) => Math.abs(right) < 0.9 && Math.abs(up) < 0.9)).toBe(true);
  expect(Math.max(...corners.flatMap(({ right, up }) => [Math.abs(right), Math.abs(up)]))).toBeGreaterThan(0.6);
  expect(camera.shows(area.east, area.south)).toBe(true);
  expect(camera.shows(area.east + 10 * (area.east - area.west), area.south)).toBe(false);
});

test("farther to the north is higher and smaller in the picture", () => {
  const camera = cameraOver({ west: -500, east: 500, south: -500, north: 500 }, ASPECT);
  const [near, far] = [camera.see(0, -400), camera.see(0, 400)];
  expect(far.up).toBeGreaterThan(near.up);
  expect(far.half).toBeGreaterThan(near.half);
});

test("of a world with goals the task is shown first, and its floor last", () => {
  const scene = { world: { ...emptyWorld(), start: [] }, lines: [], start: null };
  expect(areasOf(scene)).toHaveLength(1);
  const goal = { x: 200, y: 0, radius: 40 };
  const task = { ...scene.world, goal: { ...scene.world.goal, reach: [goal] } } as typeof scene.world;
  const areas = areasOf({ ...scene, world: task, start: [0, 0, 0] });
  const widths = areas.map(({ west, east }) => east - west);
  expect(widths).toEqual([...widths].sort((one, other) => one - other));
  expect(widths[0]).toBeLessThan(600);
  expect(widths.at(-1)).toBe(2000);
});
