import { Vector3 } from "three";
import { expect, test } from "vitest";

import { Halves } from "../../../src/views/world/halves";
import type { XY } from "../../../src/views/world/scenery/description";

const NOTHING = { top: 0, bottom: 0 };

function halves(width: number, height: number): Halves {
  const parts = new Halves();
  parts.size(width, height, NOTHING);
  return parts;
}

/** Where a place is in a half, from its middle. */
function seen(parts: Halves, half: number, [x, y]: XY): number {
  const camera = parts.lenses[half]?.camera;
  if (!camera) throw new Error("no such half");
  camera.updateMatrixWorld();
  const { x: right, y: up } = new Vector3(x, y, 0).project(camera);
  return Math.max(Math.abs(right), Math.abs(up));
}

test.each([
  [1200, 700, false],
  [390, 420, true],
])("the halves of %d x %d pixels share the picture without a gap", (width, height, high) => {
  const parts = halves(width, height);
  const [first, second] = parts.lenses;
  expect(parts.isHigh).toBe(high);
  expect(first).toMatchObject({ left: 0, top: 0 });
  expect(second).toMatchObject(high ? { left: 0, top: 0.5 } : { left: 0.5, top: 0 });
  expect((first?.width ?? 0) * (first?.height ?? 0)).toBe(0.5);
});

test("each half follows its own robot, wherever the other one goes", () => {
  const parts = halves(1200, 700);
  parts.start([
    [-1000, 300],
    [-1000, -300],
  ]);
  let moving = true;
  for (let frame = 0; frame < 500 && moving; frame += 1) {
    const places: XY[] = [
      [Math.min(2000, -1000 + 20 * frame), 300],
      [-1000, -300],
    ];
    moving = parts.step(places, 20 * frame, false) || frame < 150;
  }
  expect(moving).toBe(false);
  expect(seen(parts, 0, [2000, 300])).toBeLessThan(0.6);
  expect(seen(parts, 1, [-1000, -300])).toBeLessThan(0.01);
  expect(seen(parts, 1, [2000, 300])).toBeGreaterThan(1);
});

test("zooming in makes both robots larger", () => {
  const parts = halves(1200, 700);
  parts.start([
    [0, 0],
    [500, 0],
  ]);
  const before = [seen(parts, 0, [100, 0]), seen(parts, 1, [600, 0])];
  parts.zoom(0.5);
  expect(seen(parts, 0, [100, 0])).toBeGreaterThan(1.5 * (before[0] ?? 0));
  expect(seen(parts, 1, [600, 0])).toBeGreaterThan(1.5 * (before[1] ?? 0));
});
