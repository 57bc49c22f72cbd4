/** The values that matter most to a program, which the world shows, and their readings to plot. */

import { QUANTITIES, type Sensor, type Telemetry } from "../protocol/messages";
import type { Odometer } from "./odometer";

/** A device, and after a colon the place of its sensors if it has several: `DistanceSensors:front`. */
export type Measure = string;

/** The most measures that are shown. */
const MOST = 5;
const HEADING: Measure = "Heading";
const DRIVEN: Measure = "Driven";
/** What the program's questions have found in the camera's picture. */
export const FOUND: Measure = "Camera";
/** Shown for a program that asks for nothing. */
const USUAL: Measure = "DistanceSensors:front";
/** The devices that measure something to show; a robot's base and gyroscope answer with its heading. */
const SENSORS: ReadonlySet<string> = new Set(Object.keys(QUANTITIES).filter((device) => device !== "Gyroscope"));

/** What to show of a program: what its questions need, then how the robot moves. */
export function measuresOf(asked: readonly string[]): Measure[] {
  const sensed = asked.flatMap(measureOf);
  return [...new Set([...(sensed.length > 0 ? sensed : [USUAL]), HEADING, DRIVEN])].slice(0, MOST);
}

/** Sensors of the ground belong together; distances are shown by side. */
function measureOf(asked: string): Measure[] {
  const [device = ""] = asked.split(":");
  if (device === FOUND) return [FOUND];
  if (!SENSORS.has(device)) return [];
  return [device === "DistanceSensors" ? asked : device];
}

/** The readings of a robot: of its sensors, then its heading and the way that it has driven. */
export function readingsOf(telemetry: Telemetry, odometer: Odometer): Sensor[] {
  const way = odometer.read(telemetry);
  const [robot] = telemetry.robots;
  const sensors = telemetry.sensors ?? [];
  if (way === null || !robot) return sensors;
  return [...sensors, ...motionOf(robot.heading, way)];
}

/** The same at a moment of the past, to which the robot has taken a way. */
export function pastReadingsOf(telemetry: Telemetry, way: readonly (readonly [number, number])[]): Sensor[] {
  const [robot] = telemetry.robots;
  const motion = robot ? motionOf(robot.heading, lengthOf(way)) : [];
  return [...(telemetry.sensors ?? []), ...motion];
}

/** The heading and the way driven as readings. */
export function motionOf(heading: number, way: number): Sensor[] {
  return [
    { device: "Heading", key: "ROBOT", value: heading },
    { device: "Driven", key: "ROBOT", value: Math.round(way) },
  ];
}

/** Whether a sensor gives the values of a measure. */
export function measures(measure: Measure, sensor: Sensor): boolean {
  const [device, place] = measure.split(":");
  return sensor.device === device && (place === undefined || sensor.place === place);
}

/** The length of a way, mm. */
export function lengthOf(way: readonly (readonly [number, number])[]): number {
  return way.slice(1).reduce((sum, [x, y], index) => {
    const [fromX, fromY] = way[index] ?? [x, y];
    return sum + Math.hypot(x - fromX, y - fromY);
  }, 0);
}
