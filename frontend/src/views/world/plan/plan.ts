/** The plan of a world: its floor and its objects from above. */

import type { WorldValues } from "../scenery/description";
import { groundOf } from "./ground";
import { shapesOf } from "./shapes";
import { allThings } from "./sorts";

export function planOf(world: WorldValues): SVGElement[] {
  return [...groundOf(world), ...allThings(world).flatMap((ref) => shapesOf(world, ref))];
}
