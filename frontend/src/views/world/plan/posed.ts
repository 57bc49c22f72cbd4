/** Shapes that stand at a place and face somewhere. */

import { friendly } from "../scenery/colours";
import type { BoxValues, DoorValues } from "../scenery/description";
import type { Pose } from "../scenery/geometry";
import { svg } from "./svg";

export type Shapes = SVGElement[];

/** Objects with a pose, drawn facing east. */
export function posed({ x, y, heading }: Pose, ...shapes: Shapes): SVGElement {
  return svg("g", { transform: `translate(${x} ${-y}) rotate(${heading})` }, ...shapes);
}

/** A box from above, with a class. */
export function rectangle({ length, width, colour }: BoxValues | DoorValues, kind: string): SVGElement {
  const place = { x: -length / 2, y: -width / 2, width: length, height: width };
  return svg("rect", { ...place, class: kind, fill: friendly(colour) });
}
