/** The cameras: following the robot, through its eye, orbiting, or from above; two robots side by side have their own. */

import { MOUSE, PerspectiveCamera, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { Circling } from "./circling";
import { type Covered, fitFree, freePart } from "./covered";
import { Following } from "./following";
import { FIELD, frame, type Subject } from "./framing";
import type { EyePose } from "./robots";
import type { XY } from "./scenery/description";
import { between, forward, type Pose, radians } from "./scenery/geometry";
import { Together } from "./together";

export type CameraMode = "follow" | "eye" | "orbit" | "top" | "split";

/** The duration of a camera movement in ms. */
const MOVE = 400;
/** ms after the user has moved the camera until it follows again. */
const PAUSE = 3000;
/** A robot that is farther from its start than this has left it, mm. */
const LEFT = 30;
/** The eye of a robot sees more at once, degrees. */
const EYE_FIELD = 62;
const UP = new Vector3(0, 0, 1);
const FROM_SOUTH = new Vector3(0, -0.8, 1).normalize();
// Slightly to the south, so that north is up on the screen.
const FROM_ABOVE = new Vector3(0, -0.001, 1).normalize();
const STEEPEST = 0.001;
const FLATTEST = 1.5;
/** How far in front of the floor's centre the camera may look, as a share of its depth: near objects appear larger. */
const SHIFTS = [0, -0.03, -0.06, -0.09, -0.12, -0.15];
/** The share of the picture that the world fills. */
const FILLED = 0.94;

interface Look {
  readonly place: Vector3;
  readonly target: Vector3;
}

interface Move {
  readonly from: Look;
  readonly to: Look;
  readonly start: number;
}

export class Cameras {
  readonly camera = new PerspectiveCamera(FIELD, 1, 20, 45_000);
  mode: CameraMode = "follow";
  private readonly controls: OrbitControls;
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  private floorSize: XY = [2000, 2000];
  private subject: Subject | null = null;
  private move: Move | null = null;
  /** What it shows, also after a resize, until the user moves it. */
  private shows: "whole" | "start" | null = null;
  private readonly following = new Following(this.camera);
  private readonly together = new Together(this.camera);
  /** Goes round the robots, and what is shown again after that. */
  private circling: { step: Circling; after: CameraMode; look: Look } | null = null;
  /** The time from which on it follows, in ms; later than all times while the user moves it. */
  private followsFrom = 0;
  private waiting = 0;

  /** @param changed is called when a redraw is needed. */
  constructor(
    canvas: HTMLElement,
    private readonly changed: () => void,
  ) {
    this.camera.up.copy(UP);
    this.camera.position.copy(FROM_SOUTH).multiplyScalar(3000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = 150;
    this.controls.maxDistance = 14000;
    this.controls.addEventListener("change", () => this.changed());
    this.controls.addEventListener("start", () => this.taken());
    this.controls.addEventListener("end", () => this.released());
    this.apply("follow");
  }

  /** See `fitFree`. */
  size(width: number, height: number, covered: Covered = { top: 0, bottom: 0 }): void {
    fitFree(this.camera, width, height, covered);
    if (this.shows) this.reset();
  }

  /** Whether the user wants little motion. */
  get isCalm(): boolean {
    return this.calm.matches;
  }

  /** Set the floor's size. */
  floor(size: XY): void {
    this.floorSize = size;
  }

  /** Set what the following camera shows first: the robot where it starts, and its first goal. */
  start(subject: Subject): void {
    this.subject = subject;
  }

  choose(mode: CameraMode): void {
    const wasEye = this.mode === "eye";
    this.apply(mode);
    if (mode === "eye" || mode === "split") this.shows = this.move = null;
    else this.showAgain();
    // From the eye of the robot it is a cut.
    if (wasEye) this.arrive();
    this.changed();
  }

  /** Go round the robots, or show again what was shown before. */
  circle(on: boolean): void {
    if (on === (this.circling !== null)) return;
    if (on) {
      const look = this.now();
      this.move = null;
      this.circling = { step: new Circling(this.camera), after: this.mode, look };
      this.apply("orbit");
      this.controls.enabled = false;
    } else if (this.circling) {
      const { after, look } = this.circling;
      this.circling = null;
      this.apply(after);
      if (after !== "eye") this.cut(look);
    }
    this.changed();
  }

  /** Show the whole world. */
  showWhole(): void {
    if (this.mode !== "orbit" && this.mode !== "top") this.apply("orbit");
    const from = this.mode === "top" ? FROM_ABOVE : FROM_SOUTH;
    const shifts = this.mode === "top" ? [0] : SHIFTS;
    const looks = shifts.map((shift) => this.lookFrom(from, new Vector3(0, shift * this.floorSize[1], 0)));
    this.go(looks.reduce((best, look) => (distance(look) < distance(best) ? look : best)));
    this.shows = "whole";
  }

  /** Show what this camera shows first, without a movement: for the first frame. */
  reset(): void {
    if (this.mode === "eye" || this.mode === "split") return;
    this.showAgain();
    this.arrive();
  }

  /** The robot is at its start: show it there, unless the user has moved the camera. */
  restart(): void {
    if (this.shows === "start") this.showAgain();
  }

  private showAgain(): void {
    if (this.mode === "follow" && this.subject) this.showStart(this.subject);
    else this.showWhole();
  }

  private showStart(subject: Subject): void {
    this.go(frame(subject, this.camera.aspect, freePart(this.camera)));
    this.shows = "start";
  }

  /** Look at a point on the floor. */
  centre([x, y]: XY): void {
    const { place, target } = this.now();
    const shift = new Vector3(x, y, 0).sub(target);
    this.go({ place: place.add(shift), target: target.add(shift) });
  }

  /** Zoom in with a factor below 1, out with one above 1. */
  zoom(factor: number): void {
    const { place, target } = this.now();
    const offset = place.sub(target);
    const distance = between(offset.length() * factor, this.controls.minDistance, this.controls.maxDistance);
    this.go({ place: offset.setLength(distance).add(target), target });
  }

  /** Orbit by degrees, to the right and up. */
  turn(right: number, up: number): void {
    if (this.mode === "top") return this.slide(right, up);
    const { place, target } = this.now();
    const offset = place.sub(target).applyAxisAngle(UP, (right * Math.PI) / 180);
    const side = new Vector3().crossVectors(UP, offset).normalize();
    const polar = offset.angleTo(UP);
    offset.applyAxisAngle(side, between(polar - (up * Math.PI) / 180, 0.05, FLATTEST) - polar);
    this.go({ place: offset.add(target), target });
  }

  /** Keep the robots in the picture, ours first; return whether the camera is still moving. */
  follow([first, ...others]: readonly Pose[], now: number): boolean {
    if (first && this.circling) {
      const places = [first, ...others].map(({ x, y }): XY => [x, y]);
      this.circling.step.step(places, this.controls.target, now, this.calm.matches);
      return true;
    }
    if (!first || this.mode !== "follow" || this.move || now < this.followsFrom) return false;
    const { x, y } = first;
    if (others.length === 0 && this.isAtStart(x, y)) return false;
    const { target } = this.controls;
    const all = [first, ...others].map((one): XY => [one.x, one.y]);
    const moves =
      others.length > 0
        ? this.together.step(all, target, now, this.calm.matches)
        : this.following.step(x, y, target, now, this.calm.matches);
    this.controls.update();
    return moves;
  }

  /** Whether the robot is where the picture was made for. */
  private isAtStart(x: number, y: number): boolean {
    if (this.shows !== "start" || !this.subject) return false;
    return Math.hypot(x - this.subject.x, y - this.subject.y) < LEFT;
  }

  /** See what the robot's camera sees. */
  look(robot: Pose, { ahead, height, up }: EyePose): void {
    if (this.mode !== "eye") return;
    const [east, north] = forward(robot.heading);
    const { camera } = this;
    camera.position.set(robot.x + ahead * east, robot.y + ahead * north, height);
    const [level, rise] = [Math.cos(radians(up)), Math.sin(radians(up))];
    camera.lookAt(camera.position.x + level * east, camera.position.y + level * north, height + rise);
  }

  /** Continue a movement; return whether it is still moving. */
  step(now: number): boolean {
    if (!this.move) return false;
    const part = between((now - this.move.start) / MOVE, 0, 1);
    const { from, to } = this.move;
    const eased = part * part * (3 - 2 * part);
    this.camera.position.lerpVectors(from.place, to.place, eased);
    this.controls.target.lerpVectors(from.target, to.target, eased);
    if (part === 1) this.move = null;
    this.controls.update();
    return part < 1;
  }

  dispose(): void {
    clearTimeout(this.waiting);
    this.controls.dispose();
  }

  private apply(mode: CameraMode): void {
    this.mode = mode;
    const top = mode === "top";
    this.controls.enabled = mode !== "eye" && mode !== "split";
    this.camera.fov = mode === "eye" ? EYE_FIELD : FIELD;
    this.camera.updateProjectionMatrix();
    this.followsFrom = 0;
    this.controls.minPolarAngle = top ? STEEPEST : 0.02;
    this.controls.maxPolarAngle = top ? STEEPEST : FLATTEST;
    this.controls.enableRotate = !top;
    this.controls.mouseButtons = { LEFT: top ? MOUSE.PAN : MOUSE.ROTATE, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.controls.touches = { ONE: top ? TOUCH.PAN : TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN };
  }

  /** Its position, or the goal of its movement. */
  private now(): Look {
    const { place, target } = this.move?.to ?? { place: this.camera.position, target: this.controls.target };
    return { place: place.clone(), target: target.clone() };
  }

  private go(to: Look): void {
    const from = { place: this.camera.position.clone(), target: this.controls.target.clone() };
    this.move = { from, to, start: performance.now() };
    this.shows = null;
    if (this.calm.matches) this.arrive();
    this.changed();
  }

  /** The user has taken over the camera with the pointer. */
  private taken(): void {
    this.move = null;
    this.shows = null;
    clearTimeout(this.waiting);
    this.followsFrom = Number.POSITIVE_INFINITY;
  }

  private released(): void {
    this.followsFrom = performance.now() + PAUSE;
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => this.changed(), PAUSE + 20);
  }

  /** Show this at once. */
  private cut({ place, target }: Look): void {
    this.camera.position.copy(place);
    this.controls.target.copy(target);
    this.controls.update();
  }

  private arrive(): void {
    this.step(Number.POSITIVE_INFINITY);
  }

  private slide(right: number, up: number): void {
    const { place, target } = this.now();
    const shift = new Vector3(-right, up, 0).multiplyScalar(place.distanceTo(target) / 150);
    this.go({ place: place.add(shift), target: target.add(shift) });
  }

  /** From the smallest distance that shows the whole floor. */
  private lookFrom(direction: Vector3, target: Vector3): Look {
    const eye = this.camera.clone();
    eye.clearViewOffset();
    let distance = 300;
    do {
      distance *= 1.04;
      eye.position.copy(direction).multiplyScalar(distance).add(target);
      eye.lookAt(target);
      eye.updateMatrixWorld();
    } while (distance < this.controls.maxDistance && !this.seesFloor(eye));
    return { place: eye.position.clone(), target };
  }

  private seesFloor(eye: PerspectiveCamera): boolean {
    const [x, y] = [this.floorSize[0] / 2, this.floorSize[1] / 2];
    const corners: XY[] = [
      [x, y],
      [x, -y],
      [-x, y],
      [-x, -y],
    ];
    return corners.every(([east, north]) => {
      const point = new Vector3(east, north, 0).project(eye);
      return Math.max(Math.abs(point.x), Math.abs(point.y)) < FILLED;
    });
  }
}

function distance({ place, target }: Look): number {
  return place.distanceTo(target);
}
