/** What the picture of the world shows, for tests. */

import { type PerspectiveCamera, Vector3 } from "three";

import type { Subject } from "./framing";
import { isHidden } from "./hiding";
import type { XY } from "./scenery/description";

export interface Marks {
  readonly beams: boolean;
  readonly bearing: boolean;
  readonly trail: boolean;
  readonly origin: boolean;
}

export interface Drawn {
  /** The part of the picture's height that the robot takes. */
  readonly share: number;
  /** Whether the middle of the robot is visible. */
  readonly seen: boolean;
  /** Where the robot and the first goal with a place are in the picture: -1 to 1, to the right and up. */
  readonly robot: XY;
  readonly goal: XY | null;
  /** Where the other goals are. */
  readonly others: readonly XY[];
  /** Whether the beams, the arrow of the heading, the trail and the place of a sensor are shown. */
  readonly marks: Marks;
  /** The number of effects that have begun so far, such as confetti. */
  readonly effects: number;
}

/** @param effects that have begun so far. */
export function drawn(subject: Subject, camera: PerspectiveCamera, marks: Marks, effects: number): Drawn {
  const { x, y, reach, height, goal, others = [], screens } = subject;
  camera.updateMatrixWorld();
  // The corners of a square in the robot's outline, not around it.
  const half = reach * Math.SQRT1_2;
  const ups = [0, height].flatMap((z) =>
    [-half, half].flatMap((east) => [-half, half].map((north) => placeOf(camera, x + east, y + north, z)[1])),
  );
  return {
    seen: !isHidden(camera.position.toArray(), [x, y, height / 2], screens),
    share: (Math.max(...ups) - Math.min(...ups)) / 2,
    robot: placeOf(camera, x, y, 0),
    goal: goal && placeOf(camera, ...goal, 0),
    others: others.map(([east, north]) => placeOf(camera, east, north, 0)),
    marks,
    effects,
  };
}

function placeOf(camera: PerspectiveCamera, x: number, y: number, z: number): XY {
  const place = new Vector3(x, y, z).project(camera);
  return [place.x, place.y];
}
