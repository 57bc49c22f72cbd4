/** What a connected robot measures, as cards with a bar. */

import { t } from "../../i18n";
import type { RobotValues, Sensor } from "../../protocol/messages";
import { filling, readingText, sensorId, sensorName } from "../../views/output/quantities";

/** The colour of a bar by what it shows. */
export type Tone = "sense" | "motion" | "joint" | "ground";

export interface Gauge {
  readonly id: string;
  readonly name: string;
  readonly text: string;
  /** The filled part of its bar, 0 to 1. */
  readonly part: number;
  readonly tone: Tone;
}

/** mm/s and degrees/s that fill a bar. */
const FASTEST = 200;
const FASTEST_TURN = 180;
/** Sensors with many readings that say little at a glance. */
const LAST: ReadonlySet<string> = new Set(["Accelerometer", "Controller"]);

export function gauges({ sensors = [], joints = {}, speed, heading }: RobotValues): readonly Gauge[] {
  const hasGyroscope = sensors.some((one) => one.device === "Gyroscope");
  const isLast = (one: Sensor) => LAST.has(one.device);
  return [
    ...sensors.filter((one) => !isLast(one)).map(ofSensor),
    ...(typeof heading === "number" && !hasGyroscope ? [ofHeading(heading)] : []),
    ...ofSpeed(speed ?? [0, 0]),
    ...Object.entries(joints).map(([key, angle]) => ofJoint(key, angle)),
    ...sensors.filter(isLast).map(ofSensor),
  ];
}

function ofSensor(sensor: Sensor): Gauge {
  const tone = sensor.device === "GroundSensors" ? "ground" : "sense";
  const text = readingText(sensor, sensor.value);
  return { id: sensorId(sensor), name: sensorName(sensor), text, part: filling(sensor), tone };
}

function ofHeading(heading: number): Gauge {
  return {
    id: "heading",
    name: t("page-connect-heading"),
    text: `${Math.round(heading)} °`,
    part: Math.abs(heading) / 180,
    tone: "sense",
  };
}

function ofSpeed([advance, rotation]: readonly [number, number]): readonly Gauge[] {
  return [
    {
      id: "advance",
      name: t("page-connect-driving"),
      text: `${Math.round(advance)} mm/s`,
      part: Math.min(1, Math.abs(advance) / FASTEST),
      tone: "motion",
    },
    {
      id: "rotation",
      name: t("page-connect-turning"),
      text: `${Math.round(rotation)} °\u2009/\u2009s`,
      part: Math.min(1, Math.abs(rotation) / FASTEST_TURN),
      tone: "motion",
    },
  ];
}

function ofJoint(key: string, angle: number): Gauge {
  return {
    id: `joint-${key}`,
    name: t("page-connect-joint", { key }),
    text: `${Math.round(angle)} °`,
    part: Math.min(1, Math.abs(angle) / 90),
    tone: "joint",
  };
}
