/** What moves, between two messages: telemetry comes 20 times a second, pictures 60 times. */

import { between, type Pose, wrapped } from "./geometry";
import type { Robot, Telemetry } from "../messages";

const SHORTEST_PERIOD = 20;
const LONGEST_PERIOD = 250;
const USUAL_PERIOD = 50;

/** Everything that moves at one moment. */
export interface Moment {
  readonly robots: readonly Robot[];
  readonly pushed: readonly Pose[];
}

const NOTHING: Moment = { robots: [], pushed: [] };

/**
 * Leads what is drawn smoothly to what was told last.
 *
 * It runs from what was shown when a message came to what that message says, within the time that
 * messages need to come: about one period behind, and without a jump when one comes early or late.
 */
export class Motion {
  private from = NOTHING;
  private to = NOTHING;
  private arrived = 0;
  private period = USUAL_PERIOD;

  /** Take a message that came at `now`, in ms. */
  receive(telemetry: Telemetry, now: number): void {
    const gap = between(now - this.arrived, SHORTEST_PERIOD, LONGEST_PERIOD);
    this.from = this.at(now);
    this.to = momentOf(telemetry);
    this.period += (gap - this.period) / 4;
    this.arrived = now;
    if (this.from.robots.length !== this.to.robots.length) this.from = this.to;
  }

  /** Forget everything: another scene. */
  clear(): void {
    this.from = this.to = NOTHING;
  }

  /** What was told last. */
  get newest(): Moment {
    return this.to;
  }

  /** What to draw at `now`, in ms. */
  at(now: number): Moment {
    const part = between((now - this.arrived) / this.period, 0, 1);
    if (part === 1) return this.to;
    return {
      robots: this.to.robots.map((robot, i) => blendRobots(this.from.robots[i], robot, part)),
      pushed: this.to.pushed.map((pose, i) => blendPoses(this.from.pushed[i], pose, part)),
    };
  }

  /** Whether a later picture would be another one. */
  moving(now: number): boolean {
    return now - this.arrived < this.period;
  }
}

function momentOf(telemetry: Telemetry): Moment {
  const pushed = (telemetry.pushed ?? []).map(([x, y, heading]) => ({ x, y, heading }));
  return { robots: telemetry.robots, pushed };
}

function blend(a: number, b: number, part: number): number {
  return a + (b - a) * part;
}

function blendPoses(from: Pose | undefined, to: Pose, part: number): Pose {
  if (!from) return to;
  return {
    x: blend(from.x, to.x, part),
    y: blend(from.y, to.y, part),
    heading: from.heading + wrapped(to.heading - from.heading) * part,
  };
}

function blendRobots(from: Robot | undefined, to: Robot, part: number): Robot {
  if (!from) return to;
  const joints = Object.entries(to.joints ?? {}).map(([key, angle]): [string, number] => [
    key,
    blend(from.joints?.[key] ?? angle, angle, part),
  ]);
  return { ...to, ...blendPoses(from, to, part), joints: Object.fromEntries(joints) };
}
