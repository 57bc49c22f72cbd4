/** A camera that goes round the robots, near the floor: for the end of a run, seen again. */

import { type PerspectiveCamera, Vector3 } from "three";

import type { XY } from "./scenery/description";
import { radians } from "./scenery/geometry";

/** How far away and how high it is, mm; or so many times the distance between the robots, if that is more. */
const AWAY = 850;
const HIGH = 420;
const SPREAD = 1.3;
/** Where it begins, to the south-east, and how much it turns each second, degrees. */
const FIRST = -35;
const SPEED = 9;
/** How fast it turns to the robots: the exponential rate per second. */
const RATE = 4;
/** s: a longer gap between frames is a pause. */
const LONGEST = 0.1;

export class Circling {
  private angle = FIRST;
  private last: number | null = null;

  constructor(private readonly camera: PerspectiveCamera) {}

  /**
   * Move the camera and what it looks at.
   *
   * @param target is moved as well.
   * @param now in ms.
   * @param calm whether it stays on one side.
   */
  step(places: readonly XY[], target: Vector3, now: number, calm: boolean): void {
    const passed = this.last === null ? Number.POSITIVE_INFINITY : Math.min(LONGEST, (now - this.last) / 1000);
    this.last = now;
    const [east, north] = [0, 1].map((axis) => middle(places.map((place) => place[axis as 0 | 1])));
    target.lerp(new Vector3(east?.at, north?.at, 0), 1 - Math.exp(-RATE * passed));
    if (!calm && Number.isFinite(passed)) this.angle += SPEED * passed;
    const spread = Math.hypot(east?.width ?? 0, north?.width ?? 0);
    const factor = Math.max(1, (SPREAD * spread) / AWAY);
    const offset = new Vector3(AWAY, 0, HIGH).multiplyScalar(factor);
    this.camera.position.copy(offset.applyAxisAngle(new Vector3(0, 0, 1), radians(this.angle)).add(target));
    this.camera.lookAt(target);
  }
}

function middle(values: readonly number[]): { at: number; width: number } {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return { at: (least + most) / 2, width: most - least };
}
