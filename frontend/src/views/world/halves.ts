/** Two views of the world in one picture, each of which follows one robot. */

import { PerspectiveCamera, Vector3 } from "three";

import { type Covered, fitFree } from "./covered";
import { Following } from "./following";
import { FIELD } from "./framing";
import type { XY } from "./scenery/description";
import { between } from "./scenery/geometry";

/** How far the camera is from its robot at first, mm, and from where it looks: steeply, as walls are often near. */
const DISTANCE = 1300;
const FROM = new Vector3(0, -0.75, 0.66).normalize();
const NEAREST = 300;
const FARTHEST = 9000;

/** A part of the picture that a camera of its own sees, from the upper left corner: all are shares of the picture. */
export interface Lens {
  readonly camera: PerspectiveCamera;
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Where the halves are: beside each other in a wide picture, one above the other in a high one. */
type Place = Omit<Lens, "camera">;
const BESIDE: readonly Place[] = [
  { left: 0, top: 0, width: 0.5, height: 1 },
  { left: 0.5, top: 0, width: 0.5, height: 1 },
];
const BELOW: readonly Place[] = [
  { left: 0, top: 0, width: 1, height: 0.5 },
  { left: 0, top: 0.5, width: 1, height: 0.5 },
];

/** The camera of one half, and what it looks at. */
class Half {
  readonly camera = new PerspectiveCamera(FIELD, 1, 20, 45_000);
  private readonly target = new Vector3();
  private readonly following = new Following(this.camera);

  constructor() {
    this.camera.up.set(0, 0, 1);
  }

  start([x, y]: XY): void {
    this.target.set(x, y, 0);
    this.camera.position.copy(FROM).multiplyScalar(DISTANCE).add(this.target);
    this.camera.lookAt(this.target);
  }

  /** Its size in pixels, and how many of them are covered at its upper and lower edge. */
  size(width: number, height: number, covered: Covered): void {
    fitFree(this.camera, width, height, covered);
  }

  zoom(factor: number): void {
    const away = this.camera.position.clone().sub(this.target);
    away.setLength(between(away.length() * factor, NEAREST, FARTHEST));
    this.camera.position.copy(this.target).add(away);
  }

  step([x, y]: XY, now: number, calm: boolean): boolean {
    return this.following.step(x, y, this.target, now, calm);
  }
}

export class Halves {
  private readonly halves = [new Half(), new Half()];
  private places = BESIDE;
  /** What is drawn, the first robot's half first. */
  lenses: readonly Lens[] = [];

  /** Whether one half is above the other. */
  get isHigh(): boolean {
    return this.places === BELOW;
  }

  /** Look at two places at once, without a movement. */
  start(places: readonly XY[]): void {
    this.halves.forEach((half, i) => places[i] && half.start(places[i]));
  }

  /** The picture's size in pixels, and how many are covered at its upper and lower edge. */
  size(width: number, height: number, covered: Covered): void {
    this.places = width >= height ? BESIDE : BELOW;
    const [upper, lower] = this.isHigh
      ? [
          { top: covered.top, bottom: 0 },
          { top: covered.top, bottom: covered.bottom },
        ]
      : [covered, covered];
    this.halves.forEach((half, i) => {
      const { width: wide, height: high } = this.places[i] as Place;
      half.size(wide * width, high * height, (i === 0 ? upper : lower) ?? covered);
    });
    this.lenses = this.halves.map(({ camera }, i) => ({ camera, ...(this.places[i] as Place) }));
  }

  zoom(factor: number): void {
    for (const half of this.halves) half.zoom(factor);
  }

  /** Let each camera follow its robot; return whether one is still moving. */
  step(places: readonly XY[], now: number, calm: boolean): boolean {
    const moving = this.halves.map((half, i) => (places[i] ? half.step(places[i], now, calm) : false));
    return moving.includes(true);
  }
}
