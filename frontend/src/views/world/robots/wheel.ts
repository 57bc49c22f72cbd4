/** A wheel with spokes, which make its turning visible. */

import { Group } from "three";

import { Parts, roundedBox, wheelDisc } from "../scenery/solids";

export class Wheel {
  readonly object = new Group();
  readonly left: boolean;

  /**
   * @param y to the left of the robot's middle, mm; negative to the right.
   * @param x ahead of it.
   */
  constructor(
    y: number,
    private readonly radius: number,
    width: number,
    colours: { readonly tyre: string; readonly hub: string },
    x = 0,
  ) {
    this.left = y > 0;
    this.object.position.set(x, y, radius);
    const hub = radius * 0.62;
    const parts = new Parts().add(wheelDisc(radius, width), colours.tyre);
    parts.add(wheelDisc(hub, width + 2), colours.hub);
    for (const angle of [0, Math.PI / 2]) {
      const spoke = roundedBox(hub * 1.7, width + 3, hub * 0.28, 1).rotateY(angle);
      parts.add(spoke, colours.tyre);
    }
    this.object.add(parts.mesh());
  }

  /** Roll forward by mm. */
  roll(way: number): void {
    this.object.rotation.y += way / this.radius;
  }
}
