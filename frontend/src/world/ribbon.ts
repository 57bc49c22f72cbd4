/** Flat ribbons on the floor: painted lines, goals, trails. */

import { BufferGeometry, Color, Float32BufferAttribute } from "three";

import type { XY } from "./description";

/** Degrees between the points of a round end or joint. */
const ROUND_STEPS = 8;

/** A ribbon of a colour and a width in mm. */
export interface Ribbon {
  readonly points: readonly XY[];
  readonly width: number;
  readonly colour: string;
}

/** One shape of many ribbons with round ends and joints; later ones lie over earlier ones. */
export function ribbons(all: readonly Ribbon[], height: number): BufferGeometry {
  const positions: number[] = [];
  const colours: number[] = [];
  for (const ribbon of all) {
    const before = positions.length;
    strip(ribbon, height, positions);
    const { r, g, b } = new Color(ribbon.colour);
    for (let i = before; i < positions.length; i += 3) colours.push(r, g, b);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
  return geometry;
}

function strip({ points, width }: Ribbon, height: number, into: number[]): void {
  const half = width / 2;
  points.forEach((point, i) => {
    disc(point, half, height, into);
    const next = points[i + 1];
    if (next) piece(point, next, half, height, into);
  });
}

function piece([x, y]: XY, [endX, endY]: XY, half: number, z: number, into: number[]): void {
  const length = Math.hypot(endX - x, endY - y);
  if (length === 0) return;
  const [sideX, sideY] = [(-half * (endY - y)) / length, (half * (endX - x)) / length];
  const corners = [
    [x - sideX, y - sideY], [endX - sideX, endY - sideY], [endX + sideX, endY + sideY],
    [x - sideX, y - sideY], [endX + sideX, endY + sideY], [x + sideX, y + sideY],
  ] as const;
  for (const [cornerX, cornerY] of corners) into.push(cornerX, cornerY, z);
}

function disc([x, y]: XY, radius: number, z: number, into: number[]): void {
  const at = (i: number): XY => {
    const angle = (i * Math.PI) / ROUND_STEPS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  };
  for (let i = 0; i < 2 * ROUND_STEPS; i++) into.push(x, y, z, ...at(i), z, ...at(i + 1), z);
}
