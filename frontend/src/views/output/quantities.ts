/** A sensor's identity, its name and the format of its readings. */

import { t } from "../../i18n";
import { QUANTITIES, type Quantity, type Sensor } from "../../protocol/messages";

/** The farthest way that fills its bar, mm. */
const FAR = 5000;
/** Of what the page itself measures. */
const OWN_QUANTITIES: Readonly<Record<string, Quantity>> = {
  Heading: { unit: "°", lowest: -180, highest: 180, digits: 1 },
  Driven: { unit: "mm", lowest: 0, highest: FAR, digits: 1 },
};
const PLAIN: Quantity = { unit: "", lowest: 0, highest: 1, digits: 1 };

/** The unit, range and decimals of a sensor. */
export function quantityOf({ device }: Sensor): Quantity {
  return QUANTITIES[device] ?? OWN_QUANTITIES[device] ?? PLAIN;
}

/** The identity of a sensor among those of a robot. */
export function sensorId({ device, key, place = "", number = 0 }: Sensor): string {
  return [device, key, place, number].join(":");
}

/** A sensor's name in the user's language: `Distance in front 1`. */
export function sensorName({ device, place = "", number = 0 }: Sensor): string {
  return t("page-sensors-name", { device, place: place || "none", number });
}

/** A value with the unit of its sensor. */
export function readingText(sensor: Sensor, value: Sensor["value"]): string {
  const text = valueText(sensor, value);
  return typeof value === "number" ? `${text} ${quantityOf(sensor).unit}`.trim() : text;
}

/** A value without a unit. */
export function valueText(sensor: Sensor, value: Sensor["value"]): string {
  if (value === null) return "–";
  if (typeof value === "boolean") return t(value ? "page-sensors-yes" : "page-sensors-no");
  return fixed(value, quantityOf(sensor).digits);
}

/** A number with these decimals; not "-0.0". */
function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

/** The fraction of its bar that a reading fills, 0 to 1. */
export function filling(sensor: Sensor): number {
  const { lowest, highest } = quantityOf(sensor);
  const part = (Number(sensor.value ?? lowest) - lowest) / (highest - lowest);
  return Math.min(1, Math.max(0, part));
}
