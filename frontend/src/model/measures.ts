/** The values that matter most to a driver, which the world shows, and their readings to plot. */

import type { Sensor, Telemetry } from "../protocol/messages";
import type { Odometer } from "./odometer";

/** The distance ahead, the heading, and the way driven. */
export type Measure = "front" | "heading" | "driven";

/** The farthest way that fills its bar, mm. */
const FAR = 5000;

/** The readings of a robot: of its sensors, then its heading and the way that it has driven. */
export function readingsOf(telemetry: Telemetry, odometer: Odometer): Sensor[] {
  const way = odometer.read(telemetry);
  const [robot] = telemetry.robots;
  const sensors = telemetry.sensors ?? [];
  if (way === null || !robot) return sensors;
  return [...sensors, ...motionOf(robot.heading, way)];
}

/** The heading and the way driven as readings. */
export function motionOf(heading: number, way: number): Sensor[] {
  return [
    { device: "Heading", key: "ROBOT", value: heading, unit: "°", lowest: -180, highest: 180 },
    { device: "Driven", key: "ROBOT", value: Math.round(way), unit: "mm", lowest: 0, highest: FAR },
  ];
}

/** Whether a sensor gives the values of a measure. */
export function measures(measure: Measure, { device, place }: Sensor): boolean {
  if (measure === "front") return device === "DistanceSensors" && place === "front";
  return device === (measure === "heading" ? "Heading" : "Driven");
}

/** The length of a way, mm. */
export function lengthOf(way: readonly (readonly [number, number])[]): number {
  return way.slice(1).reduce((sum, [x, y], index) => {
    const [fromX, fromY] = way[index] ?? [x, y];
    return sum + Math.hypot(x - fromX, y - fromY);
  }, 0);
}
