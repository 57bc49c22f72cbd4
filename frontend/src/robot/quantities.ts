/** What each sensor measures: its unit, its range, and what it is called. */

import { t } from "../i18n";
import type { Telemetry } from "../messages";

type Value = NonNullable<Telemetry["sensors"]>[string];

interface Quantity {
  readonly unit: string;
  readonly lowest: number;
  readonly highest: number;
  readonly digits: number;
}

/** By the first word of a sensor's name; devices.py fixes the units. */
const QUANTITIES: Record<string, Quantity> = {
  Distance: { unit: "mm", lowest: 0, highest: 2000, digits: 0 },
  Ground: { unit: "%", lowest: 0, highest: 100, digits: 0 },
  Gyroscope: { unit: "°", lowest: -360, highest: 360, digits: 1 },
  Accelerometer: { unit: "m/s²", lowest: -20, highest: 20, digits: 2 },
  Light: { unit: "", lowest: 0, highest: 1023, digits: 0 },
  Bumper: { unit: "", lowest: 0, highest: 1, digits: 0 },
};
const OTHER: Quantity = { unit: "", lowest: 0, highest: 100, digits: 1 };

const WORDS: Record<string, string> = {
  Distance: "sensors.distance",
  Ground: "sensors.ground",
  Gyroscope: "sensors.gyroscope",
  Accelerometer: "sensors.accelerometer",
  Bumper: "sensors.bumper",
  Light: "sensors.light",
  front: "sensors.front",
  back: "sensors.back",
  left: "sensors.left",
  right: "sensors.right",
  central: "sensors.central",
};

export function quantity(sensor: string): Quantity {
  return QUANTITIES[sensor.split(" ")[0] ?? ""] ?? OTHER;
}

/** A sensor's name in the user's language: `Distance front 1`. */
export function sensorName(sensor: string): string {
  return sensor
    .split(" ")
    .map((word) => (WORDS[word] ? t(WORDS[word]) : word))
    .join(" ");
}

/** A reading with its unit. */
export function readingText(sensor: string, value: Value): string {
  if (value === null) return "–";
  if (typeof value === "boolean") return t(value ? "sensors.yes" : "sensors.no");
  const { unit, digits } = quantity(sensor);
  return `${value.toFixed(digits)} ${unit}`.trim();
}

/** How far a reading fills its bar, 0 to 1. */
export function filling(sensor: string, value: Value): number {
  const { lowest, highest } = quantity(sensor);
  const part = (Number(value ?? lowest) - lowest) / (highest - lowest);
  return Math.min(1, Math.max(0, part));
}
