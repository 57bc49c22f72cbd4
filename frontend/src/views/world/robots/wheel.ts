/** A wheel with spokes, which make its turning visible. */

import { Group } from "three";

import { drum, Parts, roundedBox } from "../scenery/solids";

const SPOKES = 3;

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
    const hub = radius * 0.58;
    const parts = new Parts().add(drum(radius, width, radius * 0.22).rotateX(Math.PI / 2), colours.tyre);
    parts.add(drum(hub, width + 3, 2).rotateX(Math.PI / 2), colours.hub);
    for (let i = 0; i < SPOKES; i++) {
      const spoke = roundedBox(hub * 1.55, width + 5, hub * 0.2, 1.5).rotateY((i * Math.PI) / SPOKES);
      parts.add(spoke, colours.tyre);
    }
    parts.add(drum(hub * 0.3, width + 7, 1.5).rotateX(Math.PI / 2), colours.hub);
    this.object.add(parts.mesh());
  }

  /** Roll forward by mm. */
  roll(way: number): void {
    this.object.rotation.y += way / this.radius;
  }
}
