/** Keeps several robots in the picture: the camera pulls back rather than leave one out. */

import { type PerspectiveCamera, Vector3 } from "three";

import { freeHeight } from "./following";
import type { XY } from "./scenery/description";

/** The part of the free picture, from its middle, in which all robots are. */
const INNER = 0.8;
/** mm around a robot that are seen with it, and how high its name is. */
const AROUND = 200;
const HIGH = 200;
/** Where robots fill less than this part of the inner picture, the camera comes nearer. */
const SMALL = 0.6;
/** mm: nearer than this it doesn't come. */
const NEAREST = 700;
/** The part of the way that the camera goes each second, as a rate: most of it in 400 ms. */
const RATE = 5;
/** What is left of a movement when it has arrived: mm, and a part of the distance. */
const CLOSE = { shift: 0.5, factor: 0.002 };
/** s: a longer gap between frames is a pause. */
const LONGEST = 0.1;

/** Where robots are in the picture, from -1 to 1. */
interface Extent {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

export class Together {
  private readonly point = new Vector3();
  private last = 0;
  private moves = false;

  constructor(private readonly camera: PerspectiveCamera) {}

  /**
   * Move the camera and what it looks at.
   *
   * @param target is moved as well.
   * @param now in ms.
   * @param calm moves at once instead of gently.
   * @returns whether it has not arrived.
   */
  step(places: readonly XY[], target: Vector3, now: number, calm: boolean): boolean {
    const passed = Math.min(LONGEST, (now - this.last) / 1000);
    this.last = now;
    const { middle, half } = freeHeight(this.camera);
    const extent = this.extent(places);
    const width = (extent.right - extent.left) / 2 / INNER;
    const height = (extent.high - extent.low) / 2 / (INNER * half);
    const filled = Math.max(width, height);
    const isIn = isWithin(extent, middle, half);
    if (isIn && filled > SMALL && !this.moves) return false;
    const offset = new Vector3().copy(this.camera.position).sub(target);
    const factor = Math.max(filled, NEAREST / offset.length());
    const shift = this.floorAt((extent.left + extent.right) / 2, (extent.low + extent.high) / 2);
    shift.sub(this.floorAt(0, middle)).setZ(0);
    const part = calm ? 1 : 1 - Math.exp(-RATE * passed);
    offset.multiplyScalar(factor ** part);
    target.addScaledVector(shift, part);
    this.camera.position.copy(target).add(offset);
    this.moves = shift.length() > CLOSE.shift || Math.abs(factor - 1) > CLOSE.factor;
    return this.moves;
  }

  /** The part of the picture with all robots and what is around them. */
  private extent(places: readonly XY[]): Extent {
    this.camera.updateMatrixWorld();
    const seen = places.flatMap(([x, y]) => [
      this.project(x - AROUND, y, 0),
      this.project(x + AROUND, y, 0),
      this.project(x, y - AROUND, 0),
      this.project(x, y + AROUND, HIGH),
    ]);
    const [across, up] = [seen.map(([right]) => right), seen.map(([, high]) => high)];
    return { left: Math.min(...across), right: Math.max(...across), low: Math.min(...up), high: Math.max(...up) };
  }

  private project(x: number, y: number, z: number): XY {
    this.point.set(x, y, z).project(this.camera);
    return [this.point.x, this.point.y];
  }

  /** The point of the floor that is seen somewhere in the picture. */
  private floorAt(right: number, up: number): Vector3 {
    const { position } = this.camera;
    const ray = new Vector3(right, up, 0.5).unproject(this.camera).sub(position);
    return ray.z < 0 ? ray.multiplyScalar(-position.z / ray.z).add(position) : new Vector3();
  }
}

function isWithin({ left, right, low, high }: Extent, middle: number, half: number): boolean {
  const isWide = left < -INNER || right > INNER;
  return !isWide && low >= middle - INNER * half && high <= middle + INNER * half;
}
