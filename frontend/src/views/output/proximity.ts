/** Sounds for the robot's surroundings: faster beeps nearer to an obstacle, a knock on contact. */

import type { Sensor, Telemetry } from "../../protocol/messages";
import type { Synthesizer } from "./synthesizer";

/** Obstacles nearer than this cause beeps, mm. */
const HEARD_WITHIN = 600;
/** Seconds between beeps, from the nearest obstacle to the farthest. */
const QUICKEST = 0.1;
const SLOWEST = 1;
const VOLUME = 0.06;

function nearestAhead(sensors: readonly Sensor[]): number {
  const ahead = sensors.filter(({ device, place }) => device === "DistanceSensors" && place === "front");
  const distances = ahead.map(({ value }) => value).filter((value) => typeof value === "number");
  return Math.min(Infinity, ...distances);
}

export class Proximity {
  private lastBeep = -Infinity;
  private touched = false;

  constructor(private readonly synthesizer: Synthesizer) {}

  /** `now` in seconds. */
  receive({ sensors = [] }: Telemetry, now: number): void {
    const touches = sensors.some(({ device, value }) => device === "Bumper" && value === true);
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
