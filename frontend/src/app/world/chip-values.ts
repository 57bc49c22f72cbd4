/** The readings of a measure in few words. */

import { t } from "../../i18n";
import { type Measure, measures } from "../../model/measures";
import type { Seen, Sensor } from "../../protocol/messages";
import { findingName } from "../../views/output/findings";
import { quantityOf, sensorName, valueText } from "../../views/output/quantities";

/** Null without a reading. */
export function valueInWords(measure: Measure, readings: readonly Sensor[]): string | null {
  const found = readings.filter((reading) => measures(measure, reading));
  const [first] = found;
  if (!first) return null;
  const value = Number(first.value);
  switch (first.device) {
    case "DistanceSensors":
      return distanceInWords(found);
    case "Heading":
      // Not -0.
      return t("page-world-degrees", { degrees: Math.round(value) + 0 });
    case "Driven":
      return t("page-world-mm", { mm: Math.round(value) });
    case "Controller":
      return pressedInWords(found);
    default:
      return listInWords(found, first);
  }
}

/** What the program's questions have found in the picture; null if it has asked nothing. */
export function foundInWords(found: readonly Seen[] | null | undefined): string | null {
  return found ? [...new Set(found.map(findingName))].join(", ") || "–" : null;
}

/** The nearest reading. */
function distanceInWords(readings: readonly Sensor[]): string {
  const nearest = readings.reduce((least, one) => (Number(one.value) < Number(least.value) ? one : least));
  const value = Number(nearest.value);
  const isBeyond = value >= quantityOf(nearest).highest;
  return isBeyond ? t("page-world-nothing-near") : t("page-world-mm", { mm: Math.round(value) });
}

function pressedInWords(buttons: readonly Sensor[]): string {
  const pressed = buttons.filter(({ value }) => value === true);
  return pressed.map(sensorName).join(", ") || "–";
}

/** All readings, with their unit once. */
function listInWords(readings: readonly Sensor[], first: Sensor): string {
  const values = readings.map((one) => valueText(one, one.value));
  return `${values.join(" · ")} ${quantityOf(first).unit}`.trim();
}
