/** Headings: degrees clockwise seen from above, 0 faces east. Lengths: mm. */

import type { LineValues, PartValues, XY } from "./description";

export interface Pose {
  readonly x: number;
  readonly y: number;
  readonly heading: number;
}

/** Degrees between the points of a curve, as in the simulator. */
const ARC_STEP = 3;

export function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}

/** The unit vector of a heading. */
export function forward(heading: number): XY {
  return [Math.cos(radians(heading)), -Math.sin(radians(heading))];
}

/** The heading of a vector. */
export function headingOf(x: number, y: number): number {
  return (-Math.atan2(y, x) * 180) / Math.PI;
}

/** The same direction, wrapped to -180 (inclusive) to 180 (exclusive). */
export function wrapped(heading: number): number {
  return ((((heading + 180) % 360) + 360) % 360) - 180;
}

/** The point that is `ahead` mm ahead and `left` mm to the left of a pose. */
export function from(pose: Pose, ahead: number, left = 0): XY {
  const [x, y] = forward(pose.heading);
  return [pose.x + ahead * x - left * y, pose.y + ahead * y + left * x];
}

export function between(value: number, least: number, most: number): number {
  return Math.min(most, Math.max(least, value));
}

/** The centre line's corners, as the simulator paints them. */
export function cornersOf(line: LineValues): XY[] {
  const [x, y, heading] = line.start;
  if (line.path.length) return walk({ x, y, heading }, line.path);
  const [first] = line.points;
  return line.closed && first ? [...line.points, first] : line.points;
}

function walk(start: Pose, path: readonly PartValues[]): XY[] {
  const points: XY[] = [[start.x, start.y]];
  let pose = start;
  for (const part of path) {
    const poses = part.forward === null ? curve(pose, part.turn ?? 0, part.radius ?? 0) : [ahead(pose, part.forward)];
    points.push(...poses.map(({ x, y }): XY => [x, y]));
    pose = poses.at(-1) ?? pose;
  }
  return points;
}

function ahead(pose: Pose, distance: number): Pose {
  const [x, y] = from(pose, distance);
  return { x, y, heading: pose.heading };
}

function curve(start: Pose, turn: number, radius: number): Pose[] {
  const pieces = Math.max(1, Math.ceil(Math.abs(turn) / ARC_STEP));
  return Array.from({ length: pieces }, (_, i) => alongCurve(start, (turn * (i + 1)) / pieces, radius));
}

function alongCurve(start: Pose, turn: number, radius: number): Pose {
  const side = turn < 0 ? -radius : radius;
  const [x, y] = forward(start.heading + 90);
  const [endX, endY] = forward(start.heading + turn + 90);
  return {
    x: start.x + side * (x - endX),
    y: start.y + side * (y - endY),
    heading: start.heading + turn,
  };
}
