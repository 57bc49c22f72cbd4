/** The convex hull of points in a plane. */

import type { XY } from "../../views/world/scenery/description";

/** The corners in order around the hull, found from left to right and back (Andrew's monotone chain). */
export function hull(points: readonly XY[]): XY[] {
  const sorted = points.toSorted(([x, y], [otherX, otherY]) => x - otherX || y - otherY);
  if (sorted.length < 3) return sorted;
  return [...half(sorted), ...half(sorted.toReversed())];
}

/** One side, without its last corner, which begins the other side. */
function half(sorted: readonly XY[]): XY[] {
  const side: XY[] = [];
  for (const point of sorted) {
    while (side.length > 1 && !turnsLeft(side.at(-2) as XY, side.at(-1) as XY, point)) side.pop();
    side.push(point);
  }
  return side.slice(0, -1);
}

function turnsLeft([ax, ay]: XY, [bx, by]: XY, [cx, cy]: XY): boolean {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0;
}
