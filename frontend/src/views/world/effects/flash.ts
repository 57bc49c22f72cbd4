/** A red ring that spreads from a robot that has bumped into something. */

import { Mesh, MeshBasicMaterial, RingGeometry } from "three";

import { MARKS } from "../scenery/colours";
import type { XY } from "../scenery/description";
import type { Effect } from "./effects";

const HEIGHT = 4;

export class Flash implements Effect {
  readonly object: Mesh<RingGeometry, MeshBasicMaterial>;
  readonly lasts = 450;

  /** @param reach of the robot, mm. */
  constructor([x, y]: XY, reach: number) {
    const material = new MeshBasicMaterial({
      color: MARKS.hit,
      transparent: true,
      depthWrite: false,
      toneMapped: false,
    });
    this.object = new Mesh(new RingGeometry(reach, reach * 1.25, 40), material);
    this.object.position.set(x, y, HEIGHT);
    this.object.renderOrder = 7;
  }

  show(age: number): void {
    const part = age / this.lasts;
    const size = 1 + 0.45 * part;
    this.object.scale.set(size, size, 1);
    this.object.material.opacity = 1 - part;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
