/** Placing the robot by pointer or keys while no program runs. */

import { Vector3 } from "three";
import { Throttle } from "../../ui/throttle";
import { Handle } from "./handle";
import type { Pointing } from "./pointing";
import type { XY } from "./scenery/description";
import { between, headingOf, type Pose, wrapped } from "./scenery/geometry";

/** ms between two messages during a drag. */
const PERIOD = 50;
/** ms to wait for the server's answer with the robot's pose. */
const PATIENCE = 400;
const TOUCH_PIXELS = 26;
const WHEEL_STEP = 5;
/** The height of the point by which the robot is dragged. */
const GRIP = 40;

/** The parts of the world that placing uses. */
export interface Ground {
  /** Where the robot is drawn now; null if there is none. */
  robot(): { readonly pose: Pose; readonly reach: number } | null;
  /** The size from west to east and from south to north, mm. */
  size(): XY;
  /** Whether it may be moved now. */
  allowed(): boolean;
  /** The cursor over a robot that may not be moved now. */
  refusal(): "help" | "not-allowed";
  /** Called when the robot has been placed. */
  placed(pose: Pose): void;
  changed(): void;
}

type Drag = { readonly what: "robot"; readonly offset: XY } | { readonly what: "knob" };

export class Placing {
  readonly handle = new Handle();
  /** The requested pose, until the server has answered. */
  pose: Pose | null = null;
  private drag: Drag | null = null;
  private selected = false;
  private release = 0;
  private readonly sending = new Throttle(PERIOD);
  private readonly listening = new AbortController();

  constructor(
    private readonly canvas: HTMLElement,
    private readonly pointing: Pointing,
    private readonly ground: Ground,
  ) {
    // Before the camera's listeners: dragging the robot must not turn the world.
    const options = { capture: true, signal: this.listening.signal };
    canvas.addEventListener("pointerdown", (event) => this.down(event), options);
    canvas.addEventListener("pointermove", (event) => this.moved(event), options);
    canvas.addEventListener("pointerup", (event) => this.up(event), options);
    canvas.addEventListener("pointercancel", (event) => this.up(event), options);
    canvas.addEventListener("wheel", (event) => this.wheel(event), { ...options, passive: false });
  }

  /** Show the ring, or hide it. */
  select(selected: boolean): void {
    this.selected = selected;
    this.show();
    this.ground.changed();
  }

  /** Move the ring to the robot. */
  show(): void {
    const robot = this.ground.robot();
    if (robot && this.selected && this.ground.allowed()) this.handle.show(robot.pose, robot.reach);
    else this.handle.hide();
  }

  /** Move the robot by mm and turn it by degrees; return whether that was allowed. */
  nudge(east: number, north: number, turn: number): boolean {
    const robot = this.ground.robot();
    if (!robot || !this.ground.allowed()) return false;
    const { x, y, heading } = robot.pose;
    this.put({ x: x + east, y: y + north, heading: heading + turn });
    this.settle();
    return true;
  }

  /** Use the server's pose, unless the robot is still being dragged. */
  confirm(pose: Pose): void {
    const near = this.pose && Math.hypot(pose.x - this.pose.x, pose.y - this.pose.y) < 1;
    if (near && !this.drag && Math.abs(wrapped(pose.heading - (this.pose?.heading ?? 0))) < 1) this.forget();
  }

  /** The server refused the placement. */
  forget(): void {
    clearTimeout(this.release);
    this.pose = null;
    this.ground.changed();
  }

  destroy(): void {
    this.listening.abort();
    this.sending.cancel();
    clearTimeout(this.release);
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.drag = this.grabbed(event);
    const was = this.selected;
    this.select(this.drag !== null);
    if (!this.drag || (this.drag.what === "knob" && !was)) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.style.cursor = "grabbing";
  }

  private grabbed(event: PointerEvent): Drag | null {
    const robot = this.ground.robot();
    if (!robot || !this.ground.allowed()) return null;
    const { pose, reach } = robot;
    if (this.selected && this.pointing.pixelsFrom(event, this.handle.at(pose)) < TOUCH_PIXELS) return { what: "knob" };
    const place = this.pointing.floor(event, GRIP);
    return place && this.isOver(event, pose, reach)
      ? { what: "robot", offset: [pose.x - place[0], pose.y - place[1]] }
      : null;
  }

  /** Whether the pointer is on the robot, with tolerance for fingers. */
  private isOver(event: MouseEvent, { x, y }: Pose, reach: number): boolean {
    const middle = new Vector3(x, y, GRIP);
    return this.pointing.missBy(event, middle) < reach || this.pointing.pixelsFrom(event, middle) < TOUCH_PIXELS;
  }

  /** Whether the pointer is on the robot. */
  isOnRobot(event: MouseEvent): boolean {
    const robot = this.ground.robot();
    return !!robot && this.isOver(event, robot.pose, robot.reach);
  }

  private moved(event: PointerEvent): void {
    if (this.drag) {
      event.stopImmediatePropagation();
      this.carry(event, this.drag);
    } else if (event.buttons === 0) this.hover(event);
  }

  private carry(event: PointerEvent, drag: Drag): void {
    const pose = this.ground.robot()?.pose;
    const place = this.pointing.floor(event, drag.what === "robot" ? GRIP : 0);
    if (!pose || !place || !this.ground.allowed()) return;
    const [x, y] = place;
    if (drag.what === "robot") this.put({ ...pose, x: x + drag.offset[0], y: y + drag.offset[1] });
    else this.put({ ...pose, heading: headingOf(x - pose.x, y - pose.y) });
  }

  private hover(event: PointerEvent): void {
    const robot = this.ground.robot();
    const over = robot && this.isOver(event, robot.pose, robot.reach);
    const knob = this.selected && robot && this.pointing.pixelsFrom(event, this.handle.at(robot.pose)) < TOUCH_PIXELS;
    this.canvas.style.cursor = !over && !knob ? "" : this.ground.allowed() ? "grab" : this.ground.refusal();
  }

  private up(event: PointerEvent): void {
    if (!this.drag) return;
    event.stopImmediatePropagation();
    this.drag = null;
    this.canvas.releasePointerCapture(event.pointerId);
    this.canvas.style.cursor = "grab";
    if (this.pose) this.settle();
  }

  private wheel(event: WheelEvent): void {
    const grabbed = this.drag ?? (this.ground.allowed() ? this.underWheel(event) : null);
    if (!grabbed) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.nudge(0, 0, Math.sign(event.deltaY) * WHEEL_STEP);
  }

  private underWheel(event: WheelEvent): boolean {
    const robot = this.ground.robot();
    return !!robot && this.isOver(event, robot.pose, robot.reach);
  }

  private put({ x, y, heading }: Pose): void {
    const [east, north] = this.ground.size();
    this.pose = {
      x: Math.round(between(x, -east / 2, east / 2)),
      y: Math.round(between(y, -north / 2, north / 2)),
      heading: Math.round(wrapped(heading)),
    };
    const pose = this.pose;
    this.sending.do(() => this.ground.placed(pose));
    this.show();
    this.ground.changed();
  }

  private settle(): void {
    clearTimeout(this.release);
    this.release = window.setTimeout(() => !this.drag && this.forget(), PATIENCE);
  }
}
