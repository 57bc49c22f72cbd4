/** The robot's surroundings to be heard: beeps that quicken towards an obstacle, a knock at a touch. */

import type { Telemetry } from "../messages";
import type { Synthesizer } from "./synthesizer";

/** mm ahead from which on there are beeps. */
const HEARD_WITHIN = 600;
/** Seconds between beeps, from the nearest obstacle to the farthest. */
const QUICKEST = 0.1;
const SLOWEST = 1;
const VOLUME = 0.06;

function nearestAhead(sensors: NonNullable<Telemetry["sensors"]>): number {
  const ahead = Object.entries(sensors).filter(([name]) => name.startsWith("Distance front"));
  const distances = ahead.map(([, value]) => value).filter((value) => typeof value === "number");
  return Math.min(Infinity, ...distances);
}

export class Proximity {
  private lastBeep = -Infinity;
  private touched = false;

  constructor(private readonly synthesizer: Synthesizer) {}

  /** `now` in seconds. */
  hear({ sensors = {} }: Telemetry, now: number): void {
    const touches = sensors["Bumper"] === true;
    if (touches && !this.touched) this.synthesizer.play({ hertz: 110, seconds: 0.12, volume: 4 * VOLUME });
    this.touched = touches;
    const nearness = 1 - nearestAhead(sensors) / HEARD_WITHIN;
    if (nearness > 0) this.beep(nearness, now);
  }

  private beep(nearness: number, now: number): void {
    if (now - this.lastBeep < SLOWEST + (QUICKEST - SLOWEST) * nearness) return;
    this.lastBeep = now;
    this.synthesizer.play({ hertz: 440 * (1 + nearness), seconds: 0.05, volume: VOLUME });
  }
}
