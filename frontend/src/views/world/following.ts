/** Keeps the robot in the inner part of the picture: the camera moves along only when it must. */

import { type PerspectiveCamera, Vector3 } from "three";

import { between } from "./scenery/geometry";

/** The part of the free picture, from its middle, in which the robot moves before the camera does. */
const FREE = 0.5;
/** The part of the way that the camera goes each second, as a rate. */
const RATE = 5;
/** mm: nearer than this, it has arrived. */
const CLOSE = 0.5;
/** s: a longer gap between frames is a pause. */
const LONGEST = 0.1;

export class Following {
  private readonly place = new Vector3();
  private readonly ray = new Vector3();
  private last = 0;

  constructor(private readonly camera: PerspectiveCamera) {}

  /**
   * Move the camera and what it looks at.
   *
   * @param target is moved as well.
   * @param now in ms.
   * @param calm moves at once instead of gently.
   * @returns whether it has not arrived.
   */
  step(x: number, y: number, target: Vector3, now: number, calm: boolean): boolean {
    const passed = Math.min(LONGEST, (now - this.last) / 1000);
    this.last = now;
    this.camera.updateMatrixWorld();
    this.place.set(x, y, 0).project(this.camera);
    const { middle, half } = freeHeight(this.camera);
    const right = between(this.place.x, -FREE, FREE);
    const up = between(this.place.y, middle - FREE * half, middle + FREE * half);
    const isAhead = this.place.z < 1;
    if (isAhead && right === this.place.x && up === this.place.y) return false;
    this.ray.set(right, up, 0.5).unproject(this.camera).sub(this.camera.position);
    if (!isAhead || this.ray.z >= 0) this.place.set(x, y, 0).sub(target);
    else {
      // From the floor that is seen there now to the robot.
      this.ray.multiplyScalar(-this.camera.position.z / this.ray.z).add(this.camera.position);
      this.place.set(x, y, 0).sub(this.ray);
    }
    this.place.z = 0;
    const whole = this.place.length();
    this.place.multiplyScalar(calm ? 1 : 1 - Math.exp(-RATE * passed));
    this.camera.position.add(this.place);
    target.add(this.place);
    return !calm && whole > CLOSE;
  }
}

/** The middle and half the height of the part that nothing covers, where the picture's lower edge is -1 and its upper edge 1. */
export function freeHeight({ view }: PerspectiveCamera): { middle: number; half: number } {
  if (!view) return { middle: 0, half: 1 };
  const half = view.fullHeight / view.height;
  return { middle: 1 - half + (2 * view.offsetY) / view.height, half };
}
