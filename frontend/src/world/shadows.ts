/** Soft shadows on the floor, painted rather than computed: they tell that a thing stands. */

import { BufferGeometry, Float32BufferAttribute, Mesh, MeshBasicMaterial } from "three";

import type { XY } from "./description";
import { forward, type Pose } from "./geometry";

const DARKNESS = 0.28;
/** mm over which it fades. */
const FADE = 28;
const HEIGHT = 0.8;

export const SHADE = new MeshBasicMaterial({
  vertexColors: true,
  transparent: true,
  depthWrite: false,
  polygonOffset: true,
  polygonOffsetFactor: -2,
});

/** The outline of something that stands at a pose, anticlockwise seen from above. */
export function rectangle(pose: Pose, length: number, width: number): XY[] {
  const [x, y] = forward(pose.heading);
  const corners: XY[] = [[1, -1], [1, 1], [-1, 1], [-1, -1]];
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

/** One mesh with the shadows of everything whose outlines are given (convex, anticlockwise). */
export function shadows(outlines: readonly (readonly XY[])[]): Mesh {
  const positions: number[] = [];
  const colours: number[] = [];
  const add = ([x, y]: XY, dark: number): void => {
    positions.push(x, y, HEIGHT);
    colours.push(0, 0, 0, dark);
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
  const outer = outline.map((point) => beyond(middle, point));
  outline.forEach((point, i) => {
    const next = (i + 1) % outline.length;
    const [a, b, farA, farB] = [point, outline[next], outer[i], outer[next]];
    if (!b || !farA || !farB) return;
    add(middle, DARKNESS), add(a, DARKNESS), add(b, DARKNESS);
    add(a, DARKNESS), add(farA, 0), add(farB, 0);
    add(a, DARKNESS), add(farB, 0), add(b, DARKNESS);
  });
}

function middleOf(outline: readonly XY[]): XY {
  const sum = outline.reduce(([x, y], [px, py]): XY => [x + px, y + py], [0, 0]);
  return [sum[0] / outline.length, sum[1] / outline.length];
}

function beyond(middle: XY, [x, y]: XY): XY {
  const [dx, dy] = [x - middle[0], y - middle[1]];
  const far = Math.hypot(dx, dy) || 1;
  return [x + (FADE * dx) / far, y + (FADE * dy) / far];
}
