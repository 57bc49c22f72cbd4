/** Finds the position in the world under a pointer. */

import { type PerspectiveCamera, Plane, Raycaster, Vector2, Vector3 } from "three";

import type { Lens } from "./halves";
import type { XY } from "./scenery/description";

/** A position on the canvas, in pixels of the page. */
interface Pointed {
  readonly clientX: number;
  readonly clientY: number;
}

type Box = Pick<DOMRect, "left" | "top" | "width" | "height">;

export class Pointing {
  private readonly caster = new Raycaster();

  /** @param lenses are the parts of the picture with a camera of their own, if there are any now. */
  constructor(
    private readonly canvas: HTMLElement,
    private readonly camera: PerspectiveCamera,
    private readonly lenses: () => readonly Lens[] = () => [],
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
    const { camera, box } = this.under(event);
    const { x, y } = point.clone().project(camera);
    const left = box.left + ((x + 1) / 2) * box.width;
    const top = box.top + ((1 - y) / 2) * box.height;
    return Math.hypot(event.clientX - left, event.clientY - top);
  }

  private ray(event: Pointed) {
    const { camera, box } = this.under(event);
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    this.caster.setFromCamera(new Vector2(x, y), camera);
    return this.caster.ray;
  }

  /** The camera whose picture is under a pointer, and where that picture is, in pixels. */
  private under({ clientX, clientY }: Pointed): { camera: PerspectiveCamera; box: Box } {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const parts = this.lenses().map(({ camera, ...part }) => ({
      camera,
      box: {
        left: left + part.left * width,
        top: top + part.top * height,
        width: part.width * width,
        height: part.height * height,
      },
    }));
    const isIn = ({ box }: { box: Box }) => clientX < box.left + box.width && clientY < box.top + box.height;
    return parts.find(isIn) ?? parts.at(-1) ?? { camera: this.camera, box: { left, top, width, height } };
  }
}
