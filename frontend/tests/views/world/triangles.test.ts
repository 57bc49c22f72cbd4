import { type BufferGeometry, Mesh, type Object3D } from "three";
import { expect, it } from "vitest";
import { Wheel } from "../../../src/views/world/robots/wheel";
import type { Theme } from "../../../src/views/world/scenery/description";
import { props } from "../../../src/views/world/scenery/props";
import { drum, roundedBox } from "../../../src/views/world/scenery/solids";

// A computer without a graphics card draws a triangle in about half a microsecond, and its shadow once more.
const THEMES: readonly Theme[] = ["city", "garden", "maze", "night", "playground", "space", "warehouse"];

const trianglesOf = (shape: BufferGeometry) => (shape.index?.count ?? 0) / 3;

function trianglesIn(object: Object3D): number {
  let all = 0;
  object.traverse((part) => {
    if (part instanceof Mesh) all += trianglesOf(part.geometry);
  });
  return all;
}

it.each(THEMES)("what is around the floor of a %s has at most 8,000 triangles", (theme) => {
  expect(trianglesIn(props(theme, [2000, 2000], 14))).toBeLessThan(8000);
});

it("a wheel has at most 600 triangles", () => {
  expect(trianglesIn(new Wheel(40, 28, 16, { tyre: "#222222", hub: "#ffffff" }).object)).toBeLessThan(600);
});

it("a box has more triangles the rounder its edges are, and twelve if they're sharp", () => {
  const boxes = [1, 6, 15].map((edge) => trianglesOf(roundedBox(100, 80, 60, edge)));
  expect(boxes[0]).toBe(12);
  expect(boxes).toEqual(boxes.toSorted((a, b) => a - b));
});

it("a larger drum has more sides", () => {
  expect(trianglesOf(drum(60, 40))).toBeGreaterThan(trianglesOf(drum(10, 40)));
});
