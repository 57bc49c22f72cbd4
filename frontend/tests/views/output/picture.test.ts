import { describe, expect, it } from "vitest";

import { labelPlace } from "../../../src/views/output/picture";

const PICTURE = { width: 320, height: 240 };

function at(left: number, top: number): [number, number][] {
  return [
    [left, top],
    [left + 40, top],
    [left + 40, top + 40],
    [left, top + 40],
  ];
}

describe("a label in the camera's picture", () => {
  it("is above what it names", () => {
    expect(labelPlace(at(100, 90), 60, PICTURE)).toEqual([100, 85]);
  });

  it.each([
    [300, 20, 120],
    [-30, -30, 80],
    [310, 260, 50],
    [100, 2, 60],
  ])("is inside of it where the thing is at %s, %s", (left, top, width) => {
    const [x, y] = labelPlace(at(left, top), width, PICTURE);
    expect(x).toBeGreaterThan(0);
    expect(x + width).toBeLessThan(PICTURE.width);
    expect(y).toBeGreaterThan(14);
    expect(y).toBeLessThan(PICTURE.height);
  });

  it("begins at the left edge if it is longer than the picture", () => {
    expect(labelPlace(at(50, 50), 400, PICTURE)[0]).toBe(3);
  });
});
