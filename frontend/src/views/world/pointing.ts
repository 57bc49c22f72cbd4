/** Finds the position in the world under a pointer. */

import { type PerspectiveCamera, Plane, Raycaster, Vector2, Vector3 } from "three";

import type { XY } from "./scenery/description";

/** A position on the canvas, in pixels of the page. */
interface Pointed {
  readonly clientX: number;
  readonly clientY: number;
}

export class Pointing {
  private readonly caster = new Raycaster();

  constructor(
    private readonly canvas: HTMLElement,
    private readonly camera: PerspectiveCamera,
  ) {}

  /** The position at a height above the floor, mm; null if the pointer is above the horizon. */
  floor(event: Pointed, height = 0): XY | null {
    const hit = this.ray(event).intersectPlane(new Plane(new Vector3(0, 0, 1), -height), new Vector3());
    return hit && [hit.x, hit.y];
  }

  /** The distance of a point from the pointer's ray, mm. */
  missBy(event: Pointed, point: Vector3): number {
    return this.ray(event).distanceToPoint(point);
  }

  /** The distance from a point on the screen, in pixels. */
  pixelsFrom(event: Pointed, point: Vector3): number {
    const box = this.canvas.getBoundingClientRect();
    const { x, y } = point.clone().project(this.camera);
    const left = box.left + ((x + 1) / 2) * box.width;
    const top = box.top + ((1 - y) / 2) * box.height;
    return Math.hypot(event.clientX - left, event.clientY - top);
  }

  private ray({ clientX, clientY }: Pointed) {
    const box = this.canvas.getBoundingClientRect();
    const x = ((clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((clientY - box.top) / box.height) * 2;
    this.caster.setFromCamera(new Vector2(x, y), this.camera);
    return this.caster.ray;
  }
}
