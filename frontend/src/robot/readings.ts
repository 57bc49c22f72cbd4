/** The sensors' readings as they are now: a row for each, with a box that chooses it for the plot. */

import { t } from "../i18n";
import type { Telemetry } from "../messages";
import { element } from "./elements";
import { filling, readingText, sensorName } from "./quantities";

type Sensors = NonNullable<Telemetry["sensors"]>;

interface Row {
  readonly dom: HTMLElement;
  show(value: Sensors[string]): void;
}

function makeRow(sensor: string, chosen: boolean, choose: (on: boolean) => void): Row {
  const box = element("input", { type: "checkbox" });
  box.checked = chosen;
  box.onchange = () => choose(box.checked);
  const fill = element("div", { class: "fill" });
  const text = element("td", { class: "reading" });
  const label = element("label", {}, box, sensorName(sensor));
  const bar = element("td", { class: "gauge", "aria-hidden": "true" }, fill);
  const dom = element("tr", {}, element("th", { scope: "row" }, label), text, bar);
  const show = (value: Sensors[string]) => {
    text.textContent = readingText(sensor, value);
    fill.style.transform = `scaleX(${filling(sensor, value)})`;
  };
  return { dom, show };
}

/** The rows; `choose` is told what the user wants to see plotted. */
export class Readings {
  private readonly title = element("caption");
  private readonly body = element("tbody");
  readonly dom = element("table", { class: "readings" }, this.title, this.body);
  private rows = new Map<string, Row>();

  /** Make rows for these sensors. */
  list(sensors: readonly string[], chosen: ReadonlySet<string>, choose: (sensor: string, on: boolean) => void): void {
    this.title.textContent = t("sensors.readings");
    this.rows = new Map(sensors.map((sensor) => [sensor, makeRow(sensor, chosen.has(sensor), (on) => choose(sensor, on))]));
    this.body.replaceChildren(...[...this.rows.values()].map(({ dom }) => dom));
  }

  show(sensors: Sensors): void {
    for (const [sensor, row] of this.rows) row.show(sensors[sensor] ?? null);
  }
}
