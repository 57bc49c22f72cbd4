/** The sensors' current readings: a row for each, with a box that chooses it for the plot. */

import { t } from "../../i18n";
import type { Sensor } from "../../protocol/messages";
import { element } from "./elements";
import { filling, readingText, sensorId, sensorName } from "./quantities";

interface Row {
  readonly dom: HTMLElement;
  readonly box: HTMLInputElement;
  show(sensor: Sensor): void;
}

function makeRow(sensor: Sensor, chosen: boolean, choose: (on: boolean) => void): Row {
  const box = element("input", { type: "checkbox" });
  box.checked = chosen;
  box.onchange = () => choose(box.checked);
  const fill = element("div", { class: "fill" });
  const text = element("td", { class: "reading" });
  const label = element("label", {}, box, sensorName(sensor));
  const bar = element("td", { class: "gauge", "aria-hidden": "true" }, fill);
  const dom = element("tr", {}, element("th", { scope: "row" }, label), text, bar);
  const show = (now: Sensor) => {
    text.textContent = readingText(now, now.value);
    fill.style.transform = `scaleX(${filling(now)})`;
  };
  return { dom, box, show };
}

/** The rows; `choose` receives the id of a sensor to plot or not. */
export class Readings {
  private readonly title = element("caption");
  private readonly body = element("tbody");
  readonly dom = element("table", { class: "readings" }, this.title, this.body);
  private rows = new Map<string, Row>();

  /** Create rows for these sensors. */
  list(sensors: readonly Sensor[], chosen: ReadonlySet<string>, choose: (id: string, on: boolean) => void): void {
    this.title.textContent = t("page-sensors-readings");
    const row = (sensor: Sensor, id: string) => makeRow(sensor, chosen.has(id), (on) => choose(id, on));
    this.rows = new Map(sensors.map((sensor) => [sensorId(sensor), row(sensor, sensorId(sensor))]));
    this.body.replaceChildren(...[...this.rows.values()].map(({ dom }) => dom));
  }

  /** Tick the boxes of these sensors, and no others. */
  tick(chosen: ReadonlySet<string>): void {
    for (const [id, { box }] of this.rows) box.checked = chosen.has(id);
  }

  show(sensors: readonly Sensor[]): void {
    for (const sensor of sensors) this.rows.get(sensorId(sensor))?.show(sensor);
  }
}
