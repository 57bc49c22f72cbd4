/** Smooth movement between messages: telemetry arrives 20 times per second, frames are drawn 60 times. */

import type { Robot, Telemetry } from "../../protocol/messages";
import type { XY } from "./scenery/description";
import type { GameMoment } from "./scenery/games";
import { between, type Pose, wrapped } from "./scenery/geometry";

const SHORTEST_PERIOD = 20;
const LONGEST_PERIOD = 250;
const USUAL_PERIOD = 50;

/** The state of everything that moves, at one moment. */
export interface Moment {
  readonly robots: readonly Robot[];
  readonly pushed: readonly Pose[];
  /** Null without things of a game. */
  readonly game: GameMoment | null;
}

const NOTHING: Moment = { robots: [], pushed: [], game: null };

/**
 * Moves the drawing smoothly to the last message.
 *
 * It interpolates from the drawing at the time of a message to that message, within the usual time
 * between messages: about one period late, and without a jump if one comes early or late.
 */
export class Motion {
  private from = NOTHING;
  private to = NOTHING;
  private arrived = 0;
  private period = USUAL_PERIOD;

  /** Take a message that arrived at `now`, in ms. */
  receive(telemetry: Telemetry, now: number): void {
    const gap = between(now - this.arrived, SHORTEST_PERIOD, LONGEST_PERIOD);
    this.from = this.at(now);
    this.to = momentOf(telemetry);
    this.period += (gap - this.period) / 4;
    this.arrived = now;
    if (this.from.robots.length !== this.to.robots.length) this.from = this.to;
  }

  /** Forget everything, for a new scene. */
  clear(): void {
    this.from = this.to = NOTHING;
  }

  /** The last message's moment. */
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
      game: this.to.game && blendGames(this.from.game, this.to.game, part),
    };
  }

  /** Whether a later frame would look different. */
  moving(now: number): boolean {
    return now - this.arrived < this.period;
  }
}

function momentOf(telemetry: Telemetry): Moment {
  const pushed = (telemetry.pushed ?? []).map(([x, y, heading]) => ({ x, y, heading }));
  return { robots: telemetry.robots, pushed, game: gameOf(telemetry) };
}

function gameOf({ game, time }: Telemetry): GameMoment | null {
  const { things = [], doors = [] } = game ?? {};
  return things.length || doors.length ? { time, things, doors } : null;
}

/** A thing that has just come back does not fly to its place. */
function blendGames(from: GameMoment | null, to: GameMoment, part: number): GameMoment {
  const things = to.things.map((thing, i): XY | null => {
    const before = from?.things[i];
    if (!thing || !before) return thing;
    return [blend(before[0], thing[0], part), blend(before[1], thing[1], part)];
  });
  return { ...to, time: blend(from?.time ?? to.time, to.time, part), things };
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
