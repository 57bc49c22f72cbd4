/** What the distance sensors read: which reading belongs to which sensor. */

import type { DistanceValues, RobotValues } from "./description";
import type { Telemetry } from "../messages";

type Sensors = NonNullable<Telemetry["sensors"]>;

/** The reading of each sensor in the order of the description, mm; null where nothing is in range. */
export function distances(robot: RobotValues, sensors: Sensors): (number | null)[] {
  const counts = new Map<string, number>();
  return robot.distance.map((sensor) => {
    const names = sensor.sides.map((side) => {
      const count = (counts.get(side) ?? 0) + 1;
      counts.set(side, count);
      return `Distance ${side} ${count}`;
    });
    return within(sensor, names.map((name) => sensors[name]).find((value) => typeof value === "number"));
  });
}

function within(sensor: DistanceValues, reading: number | boolean | null | undefined): number | null {
  return typeof reading === "number" && reading <= sensor.maximum * 1.2 ? reading : null;
}

/** What lies ahead: the nearest reading in front, null for nothing, and how far it could be seen. */
export function ahead(robot: RobotValues, sensors: Sensors): { nearest: number | null; range: number } | null {
  const front = robot.distance
    .map((sensor, i) => ({ sensor, i }))
    .filter(({ sensor }) => sensor.sides.includes("front"));
  if (!front.length || !Object.keys(sensors).some((name) => name.startsWith("Distance front"))) return null;
  const readings = distances(robot, sensors);
  const near = front.map(({ i }) => readings[i] ?? null).filter((reading) => reading !== null);
  const range = Math.min(...front.map(({ sensor }) => sensor.maximum));
  return { nearest: near.length ? Math.min(...near) : null, range };
}
