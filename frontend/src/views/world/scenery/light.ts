/** The light of a world: the sky's, and a sun that casts shadows. */

import { DirectionalLight, Group, HemisphereLight } from "three";

import type { XY } from "./description";
import type { Palette } from "./palette";

/** The pixels of the map of shadows at first. */
const SHADOWS = 1024;
/** From where the sun shines: from the south-west, high. */
const DIRECTION = [-0.5, -0.45, 1] as const;
const DARKNESS = 0.72;

export class Light {
  readonly object = new Group();
  private readonly sky = new HemisphereLight();
  private readonly sun = new DirectionalLight();

  constructor() {
    const { shadow } = this.sun;
    // Up is z here.
    this.sky.position.set(0, 0, 1);
    this.sun.castShadow = true;
    shadow.mapSize.setScalar(SHADOWS);
    shadow.intensity = DARKNESS;
    shadow.bias = -0.0004;
    shadow.normalBias = 4;
    shadow.radius = 2.5;
    this.object.add(this.sky, this.sun, this.sun.target);
  }

  /** Shine on a floor of this size, mm. */
  show([width, depth]: XY, { light, strength }: Palette): void {
    this.sky.color.set(light.above);
    this.sky.groundColor.set(light.below);
    this.sky.intensity = strength.sky;
    this.sun.color.set(light.sun);
    this.sun.intensity = strength.sun;
    const reach = Math.hypot(width, depth) / 2 + 150;
    const [x, y, z] = DIRECTION;
    this.sun.position.set(x * 2 * reach, y * 2 * reach, z * 2 * reach);
    const { camera } = this.sun.shadow;
    Object.assign(camera, {
      left: -reach,
      right: reach,
      top: reach,
      bottom: -reach,
      near: reach * 0.8,
      far: reach * 4,
    });
    camera.updateProjectionMatrix();
  }

  /** Cast shadows with a map of this many pixels; return whether they must be cast again. */
  sharpen(size: number): boolean {
    const { shadow } = this.sun;
    if (shadow.mapSize.x === size) return false;
    shadow.mapSize.setScalar(size);
    shadow.map?.dispose();
    shadow.map = null;
    return true;
  }
}
