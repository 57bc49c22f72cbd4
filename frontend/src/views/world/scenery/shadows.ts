/** Soft shadows on the floor, painted instead of computed. */

import { BufferGeometry, Float32BufferAttribute, Mesh, MeshBasicMaterial } from "three";

import type { XY } from "./description";
import { forward, type Pose } from "./geometry";

const DARKNESS = 0.24;
/** The width of the fading edge, mm. */
const FADE = 28;
const HEIGHT = 0.8;
/** Red, green and blue, 0 to 1: a dark blue. */
const SHADE_COLOUR = [0.01, 0.015, 0.06] as const;

export const SHADE = new MeshBasicMaterial({
  vertexColors: true,
  toneMapped: false,
  transparent: true,
  depthWrite: false,
  polygonOffset: true,
  polygonOffsetFactor: -2,
});

/** The outline of an object at a pose, anticlockwise seen from above. */
export function rectangle(pose: Pose, length: number, width: number): XY[] {
  const [x, y] = forward(pose.heading);
  const corners: XY[] = [
    [1, -1],
    [1, 1],
    [-1, 1],
    [-1, -1],
  ];
  return corners.map(([a, b]) => {
    const [ahead, left] = [(a * length) / 2, (b * width) / 2];
    return [pose.x + ahead * x - left * y, pose.y + ahead * y + left * x];
  });
}

export function circle(x: number, y: number, radius: number, sides = 20): XY[] {
  return Array.from({ length: sides }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** One mesh with the shadows of all these outlines (convex, anticlockwise). */
export function shadows(outlines: readonly (readonly XY[])[]): Mesh {
  const positions: number[] = [];
  const colours: number[] = [];
  const add = ([x, y]: XY, dark: number): void => {
    positions.push(x, y, HEIGHT);
    colours.push(...SHADE_COLOUR, dark);
  };
  for (const outline of outlines) shade(outline, add);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.setAttribute("color", new Float32BufferAttribute(colours, 4));
  const mesh = new Mesh(geometry, SHADE);
  mesh.renderOrder = 5;
  return mesh;
}

function shade(outline: readonly XY[], add: (point: XY, dark: number) => void): void {
  const middle = middleOf(outline);
  const count = outline.length;
  const at = (i: number): XY => outline[(i + count) % count] as XY;
  outline.forEach((a, i) => {
    const b = at(i + 1);
    const [before, side] = [outwards(at(i - 1), a), outwards(a, b)];
    const [farA, farB] = [away(a, side), away(b, side)];
    for (const point of [middle, a, b]) add(point, DARKNESS);
    add(a, DARKNESS);
    add(farA, 0);
    add(farB, 0);
    add(a, DARKNESS);
    add(farB, 0);
    add(b, DARKNESS);
    add(a, DARKNESS);
    add(away(a, before), 0);
    add(farA, 0);
  });
}

function middleOf(outline: readonly XY[]): XY {
  const sum = outline.reduce(([x, y], [px, py]): XY => [x + px, y + py], [0, 0]);
  return [sum[0] / outline.length, sum[1] / outline.length];
}

/** The outward direction of a side. */
function outwards([x, y]: XY, [endX, endY]: XY): XY {
  const length = Math.hypot(endX - x, endY - y) || 1;
  return [(endY - y) / length, (x - endX) / length];
}

function away([x, y]: XY, [dx, dy]: XY): XY {
  return [x + FADE * dx, y + FADE * dy];
}
