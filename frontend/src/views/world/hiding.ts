/** What blocks the view of the camera. */

import type { BoardValues, WorldValues, XY } from "./scenery/description";
import { circle, rectangle } from "./scenery/shadows";
import { piecesOf } from "./scenery/things";

const BOARD_THICKNESS = 8;
const CYLINDER_SIDES = 8;

/** East, north, up. */
export type Point = readonly [number, number, number];

/** An upright solid that nothing is seen through. */
export interface Screen {
  readonly outline: readonly XY[];
  readonly bottom: number;
  readonly top: number;
}

/** Everything in a world that can hide something. */
export function screensOf({ wall, box, cylinder, tag, face }: WorldValues): Screen[] {
  return [
    ...wall.flatMap((one) =>
      piecesOf(one).map(({ pose, length }) => standing(rectangle(pose, length, one.thickness), one.height)),
    ),
    ...box.map((one) => standing(rectangle(one, one.length, one.width), one.height)),
    ...cylinder.map((one) => standing(circle(one.x, one.y, one.radius, CYLINDER_SIDES), one.height)),
    ...[...tag, ...face].map(board),
  ];
}

function standing(outline: XY[], top: number): Screen {
  return { outline, bottom: 0, top };
}

function board(one: BoardValues): Screen {
  const outline = rectangle(one, BOARD_THICKNESS, one.size);
  return { outline, bottom: one.z - one.size / 2, top: one.z + one.size / 2 };
}

/** Whether a straight view from one point to another meets a screen. */
export function isHidden(from: Point, to: Point, screens: readonly Screen[]): boolean {
  return screens.some(({ outline, bottom, top }) =>
    outline.some((corner, i) => {
      const part = crossing(from, to, corner, outline[(i + 1) % outline.length] ?? corner);
      if (part === null) return false;
      const height = from[2] + part * (to[2] - from[2]);
      return height > bottom && height < top;
    }),
  );
}

/** The part of the way from one point to another at which it crosses a line, seen from above; null if it does not. */
function crossing([x, y]: Point, [toX, toY]: Point, [ax, ay]: XY, [bx, by]: XY): number | null {
  const [dx, dy, sideX, sideY] = [toX - x, toY - y, bx - ax, by - ay];
  const turn = dx * sideY - dy * sideX;
  if (turn === 0) return null;
  const along = ((ax - x) * sideY - (ay - y) * sideX) / turn;
  const across = ((ax - x) * dy - (ay - y) * dx) / turn;
  return along > 0 && along < 1 && across >= 0 && across <= 1 ? along : null;
}
