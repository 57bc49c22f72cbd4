/** What the board looks at the world through: a plan, or the room in 3D. */

import type { Ref } from "../../views/world/plan/sorts";
import type { WorldValues, XY } from "../../views/world/scenery/description";

/** A place on the page. */
export interface Pointed {
  readonly clientX: number;
  readonly clientY: number;
}

export interface Lens {
  /** The picture below the marks; null if the marks are the picture. */
  readonly picture: HTMLElement | null;
  /** The units of the marks in a pixel. */
  readonly scale: number;
  /** The middle of what is seen, in the world. */
  readonly centre: XY;
  show(world: WorldValues): void;
  /** The floor, as marks. */
  ground(world: WorldValues): SVGElement[];
  /** An object, as marks. */
  shapes(world: WorldValues, ref: Ref): SVGElement[];
  /** The marks' position of a place in the world. */
  point(place: XY): XY;
  /** The place in the world under a pointer. */
  at(pointed: Pointed): XY;
  /** Show a whole floor. */
  fit(size: XY): void;
  /** Zoom in with a factor below 1. */
  zoom(factor: number, place?: XY): void;
  /** Shift by pixels, or turn. */
  pan(right: number, down: number): void;
  resized(): void;
  destroy(): void;
}
