/** Where the values of the robot come from: the beams of its sensors, and marks of what the user points at. */

import { type ReadonlySignal, signal } from "@preact/signals";

import type { Measure } from "../../model/measures";
import type { Running } from "../../model/running";
import type { Telemetry } from "../../protocol/messages";
import { Bearing } from "./bearing";
import type { Stage } from "./stage";

/** Devices whose values have a mark of their own. */
const SHOWN_OTHERWISE: ReadonlySet<string> = new Set(["DistanceSensors", "Heading", "Driven"]);

export class MeasureMarks {
  readonly bearing = new Bearing();
  private readonly shows = signal(false);
  /** The value that the user points at. */
  private pointed: Measure | null = null;

  /** @param stage returns what is drawn; null without a world. */
  constructor(
    private readonly running: Running,
    private readonly stage: () => Stage | null,
  ) {}

  /** Whether the user wants to see all beams. */
  get shown(): ReadonlySignal<boolean> {
    return this.shows;
  }

  toggle(): void {
    this.shows.value = !this.shows.value;
    this.showBeams();
  }

  /** Mark where a value comes from. */
  point(measure: Measure | null): void {
    this.pointed = measure;
    this.bearing.object.visible = measure === "Heading";
    this.show();
  }

  /** Show the marks in a world that has just been built. */
  show(): void {
    this.showBeams();
    this.showOrigin();
  }

  receive(telemetry: Telemetry): void {
    const beams = this.stage()?.beams;
    if (beams?.object.visible) beams.show(telemetry);
  }

  /** Draw the arrow of the heading at the robot. */
  draw(): void {
    const robot = this.stage()?.robots[0];
    if (robot && this.bearing.object.visible) this.bearing.show(robot.pose, robot.reach);
  }

  /** The user's beams, or those that measure what is pointed at. */
  private showBeams(): void {
    const beams = this.stage()?.beams;
    if (!beams) return;
    const all = this.shows.peek();
    const [device, side = null] = this.pointed?.split(":") ?? [];
    const isPointed = device === "DistanceSensors";
    beams.object.visible = all || isPointed;
    beams.single(all || !isPointed ? null : side);
    const telemetry = this.running.telemetry.peek();
    if (telemetry) beams.show(telemetry);
  }

  /** Mark the sensors that are pointed at, unless beams, the arrow or the trail show them. */
  private showOrigin(): void {
    const [device = null] = this.pointed?.split(":") ?? [];
    const isShown = device !== null && SHOWN_OTHERWISE.has(device);
    this.stage()?.point(isShown ? null : device);
  }
}
