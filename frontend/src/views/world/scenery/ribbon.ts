/** Flat ribbons on the floor: painted lines, goals, trails. */

import { BufferGeometry, Color, Float32BufferAttribute } from "three";

import type { XY } from "./description";

/** Points of half a round end or joint. */
const ROUND_STEPS = 8;

/** A ribbon of a colour and a width in mm. */
export interface Ribbon {
  readonly points: readonly XY[];
  readonly width: number;
  readonly colour: string;
}

/** One shape of many ribbons with round ends and joints; later ones are drawn over earlier ones. */
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

/** Ends closer than this count as a closed line, mm: the simulator's tolerance. */
const CLOSED = 5;
/** A joint that turns by more than this gets a disc; others are mitred, which overlaps less. */
const SHARP = Math.cos(Math.PI / 6);

function strip({ points: all, width }: Ribbon, height: number, into: number[]): void {
  const way = all.filter((point, i) => i === 0 || gap(point, all[i - 1]) > 0);
  const half = width / 2;
  const closed = way.length > 2 && gap(way[0], way.at(-1)) < CLOSED;
  const points = closed ? way.with(-1, way[0] as XY) : way;
  const before = (i: number): XY | undefined => points[i - 1] ?? (closed ? points.at(-2) : undefined);
  const after = (i: number): XY | undefined => points[i + 1] ?? (closed ? points[1] : undefined);
  const sides = points.map((point, i) => sideAt(before(i), point, after(i)));
  points.forEach((point, i) => {
    const [side, next, nextSide] = [sides[i], points[i + 1], sides[i + 1]];
    if (!side) disc(point, half, height, into);
    if (next) piece(point, next, [side ?? null, nextSide ?? null], half, height, into);
  });
}

function gap(a: XY | undefined, b: XY | undefined): number {
  return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : Number.POSITIVE_INFINITY;
}

function direction([x, y]: XY, [endX, endY]: XY): XY {
  const length = Math.hypot(endX - x, endY - y) || 1;
  return [(endX - x) / length, (endY - y) / length];
}

function isSharp(before: XY | undefined, point: XY, after: XY | undefined): boolean {
  if (!before || !after) return true;
  const [a, b] = [direction(before, point), direction(point, after)];
  return a[0] * b[0] + a[1] * b[1] < SHARP;
}

/** The ribbon's left edge at a mitred joint, from its centre, in half widths. */
function sideAt(before: XY | undefined, point: XY, after: XY | undefined): XY | null {
  if (!before || !after || isSharp(before, point, after)) return null;
  const [a, b] = [direction(before, point), direction(point, after)];
  const scale = 1 / (1 + a[0] * b[0] + a[1] * b[1]);
  return [-(a[1] + b[1]) * scale, (a[0] + b[0]) * scale];
}

type Sides = readonly [XY | null, XY | null];

function piece(start: XY, end: XY, [first, last]: Sides, half: number, z: number, into: number[]): void {
  const [dx, dy] = direction(start, end);
  const edge = ([x, y]: XY, side: XY | null, sign: number): XY => {
    const [sideX, sideY] = side ?? [-dy, dx];
    return [x + sign * half * sideX, y + sign * half * sideY];
  };
  const [a, b, c, d] = [edge(start, first, -1), edge(end, last, -1), edge(end, last, 1), edge(start, first, 1)];
  for (const corner of [a, b, c, a, c, d]) into.push(...corner, z);
}

function disc([x, y]: XY, radius: number, z: number, into: number[]): void {
  const at = (i: number): XY => {
    const angle = (i * Math.PI) / ROUND_STEPS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  };
  for (let i = 0; i < 2 * ROUND_STEPS; i++) into.push(x, y, z, ...at(i), z, ...at(i + 1), z);
}
