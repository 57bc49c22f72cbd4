/** Where the robot has driven: its trail, or the ways of compared runs. */

import { type ReadonlySignal, signal } from "@preact/signals";
import type { Object3D } from "three";

import type { Way } from "../../model/kept-runs";
import type { Running } from "../../model/running";
import type { Robot } from "../../protocol/messages";
import { Trail } from "./trail";
import { Ways } from "./ways";

/** A robot that moves farther than this between two messages was placed, mm. */
const LEAP = 20;

export class DrivenWay {
  private readonly trail = new Trail();
  private readonly ways = new Ways();
  private readonly shows = signal(true);
  /** Whether the user points at the way driven. */
  private isPointed = false;
  /** Whether the trail is hidden because it would cover a drawing. */
  private isBelow = false;
  /** Whether the trail is that of the past. */
  private showsPast = false;
  private lastSeen: { robot: Robot; time: number } | null = null;

  /** @param changed is called when the picture has to be drawn again. */
  constructor(
    private readonly running: Running,
    private readonly changed: () => void,
  ) {}

  get objects(): Object3D[] {
    return [this.trail.mesh, this.ways.object];
  }

  /** Whether the user wants to see the trail. */
  get shown(): ReadonlySignal<boolean> {
    return this.shows;
  }

  /** Whether the trail is in the picture. */
  get visible(): boolean {
    return this.trail.mesh.visible;
  }

  /** Begin a new trail. */
  clear(): void {
    this.trail.clear();
  }

  destroy(): void {
    this.ways.clear();
  }

  toggle(): void {
    this.shows.value = !this.shows.value;
    this.show();
  }

  /** Highlight it, or not any more. */
  point(on: boolean): void {
    this.isPointed = on;
    this.show();
  }

  /** The trail follows the pen and is as wide as its lines, so a drawing takes its place. */
  giveWay(isDrawn: boolean): void {
    if (isDrawn !== this.isBelow && isDrawn === this.shows.peek()) this.toggle();
    this.isBelow = isDrawn;
  }

  /** The ways of compared runs take the trail's place. */
  compare(ways: readonly Way[]): void {
    this.ways.show(ways);
    this.show();
  }

  /** Show the trail up to a moment that the user looks back at, or to the present again. */
  until(time: number): void {
    this.showsPast = this.running.past.peek() !== null;
    this.trail.clear();
    for (const [x, y] of this.running.wayUntil(time)) this.trail.extend(x, y);
  }

  /** A robot that moved without time passing was placed: start a new trail. */
  advance(robot: Robot, time: number): void {
    if (this.running.past.peek() || this.showsPast) return this.until(time);
    const last = this.lastSeen;
    this.lastSeen = { robot, time };
    const way = last ? Math.hypot(robot.x - last.robot.x, robot.y - last.robot.y) : 0;
    if (last && (time < last.time || (time === last.time && way > LEAP))) this.trail.clear();
    this.trail.extend(robot.x, robot.y);
  }

  private show(): void {
    this.trail.mesh.visible = (this.shows.peek() || this.isPointed) && this.ways.empty;
    this.trail.highlight(this.isPointed);
    this.changed();
  }
}
