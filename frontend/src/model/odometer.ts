/** How far a robot has driven, from one telemetry to the next. */

import type { Telemetry } from "../protocol/messages";

/** mm; a robot that moved farther at once, or without time passing, was placed. */
const LEAP = 200;

interface Place {
  readonly time: number;
  readonly x: number;
  readonly y: number;
}

export class Odometer {
  private last: Place | null = null;
  private way = 0;

  /** The distance in mm after a telemetry; null if the place of the robot is not known. */
  read(telemetry: Telemetry | null): number | null {
    const robot = telemetry?.robots[0];
    if (!telemetry || !robot || robot.located === false) return this.reset();
    const { last } = this;
    this.last = { time: telemetry.time, x: robot.x, y: robot.y };
    if (!last || telemetry.time < last.time) this.way = 0;
    else if (telemetry.time > last.time) this.way += stepOf(last, this.last);
    return this.way;
  }

  private reset(): null {
    this.last = null;
    this.way = 0;
    return null;
  }
}

function stepOf(last: Place, now: Place): number {
  const step = Math.hypot(now.x - last.x, now.y - last.y);
  return step < LEAP ? step : 0;
}
