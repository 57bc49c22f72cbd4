/** Assigns readings to distance sensors. */

import type { Sensor } from "../../../protocol/messages";
import type { DistanceValues, RobotValues } from "./description";

/** The reading of each sensor in the order of the description, mm; null if nothing is in range. */
export function distances(robot: RobotValues, sensors: readonly Sensor[]): (number | null)[] {
  const counts = new Map<string, number>();
  return robot.distance.map((sensor) => {
    const values = sensor.sides.map((side) => {
      const count = (counts.get(side) ?? 0) + 1;
      counts.set(side, count);
      return distance(sensors, side, count);
    });
    return within(sensor, values.find((value) => value !== null) ?? null);
  });
}

function distance(sensors: readonly Sensor[], side: string, count: number): number | null {
  const found = sensors.find(
    ({ device, place, number }) => device === "DistanceSensors" && place === side && number === count,
  );
  return typeof found?.value === "number" ? found.value : null;
}

function within(sensor: DistanceValues, reading: number | null): number | null {
  return reading !== null && reading <= sensor.maximum * 1.2 ? reading : null;
}

/** The nearest reading in front, null for nothing, and the sensor's range. */
export function ahead(
  robot: RobotValues,
  sensors: readonly Sensor[],
): { nearest: number | null; range: number } | null {
  const front = robot.distance
    .map((sensor, i) => ({ sensor, i }))
    .filter(({ sensor }) => sensor.sides.includes("front"));
  const measures = sensors.some(({ device, place }) => device === "DistanceSensors" && place === "front");
  if (!front.length || !measures) return null;
  const readings = distances(robot, sensors);
  const near = front.map(({ i }) => readings[i] ?? null).filter((reading) => reading !== null);
  const range = Math.min(...front.map(({ sensor }) => sensor.maximum));
  return { nearest: near.length ? Math.min(...near) : null, range };
}
