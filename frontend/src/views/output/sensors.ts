/** The robot's sensors: numbers, bars, a plot of the last minute, and export. */

import "./panel.css";
import "./sensors.css";

import { effect, type Signal, signal } from "@preact/signals";
import { language, t } from "../../i18n";
import type { Context } from "../../model/context";
import { type Measure, measures, pastReadingsOf, readingsOf } from "../../model/measures";
import { Odometer } from "../../model/odometer";
import { preferences } from "../../model/preferences";
import type { Sensor, Telemetry } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { button, download, element } from "./elements";
import { Plot, SHOWN_SECONDS } from "./plot";
import { readingText, sensorId, sensorName } from "./quantities";
import { Readings } from "./readings";
import { type Reading, Recording } from "./recording";
import { createTable, type Row } from "./table";
import { watchVisibility } from "./visibility";

export interface SensorsIsland extends Island {
  resize(): void;
}

/** Milliseconds between two drawings. */
const DRAWING_PERIOD = 66;
/** Milliseconds between two updates of the summary table. */
const SUMMARY_PERIOD = 1000;
/** Types of sensors of which the first is plotted before the user has chosen. */
const PLOTTED_AT_FIRST = ["DistanceSensors", "GroundSensors", "Gyroscope"];

class Sensors implements SensorsIsland {
  private readonly nothing = element("p", { class: "nothing" });
  private readonly readings = new Readings();
  private readonly picture = element("div", { class: "plot", role: "img" });
  private readonly summary = createTable();
  private readonly summaryTitle = element("summary");
  private readonly save = button("tool", () => this.download());
  readonly dom = element("section", { class: "robot-panel sensors scroll", tabindex: "0" });

  private readonly recording = new Recording();
  private readonly odometer = new Odometer();
  private readonly plot = new Plot(this.picture);
  private readonly visibility = watchVisibility(this.dom);
  /** Every sensor, and the ids of those to plot. */
  private readonly known = signal<readonly Sensor[]>([]);
  private readonly chosen = signal<ReadonlySet<string>>(new Set());
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly replot = () => {
    this.outdated = true;
    this.schedule();
  };
  private readonly cleanup: Cleanup;
  private present: readonly Sensor[] = [];
  private outdated = true;
  private frame = 0;
  private drawn = 0;
  private summarised = 0;

  constructor(
    private readonly context: Context,
    private readonly wanted: Signal<Measure | null>,
  ) {
    const details = element("details", {}, this.summaryTitle, this.summary.dom);
    const tools = element("div", { class: "tools" }, this.save);
    this.dom.append(this.nothing, this.readings.dom, this.picture, details, tools);
    this.dark.addEventListener("change", this.replot);
    this.cleanup = new Cleanup(
      effect(() => this.record(context.running.measured.value)),
      effect(() => void [context.running.past.value, this.schedule()]),
      effect(() => this.nameAll()),
      effect(() => this.plotWanted()),
      effect(() => this.followPlot()),
    );
  }

  resize(): void {
    this.plot.resize();
  }

  destroy(): void {
    this.cleanup.dispose();
    this.dark.removeEventListener("change", this.replot);
    this.visibility.destroy();
    cancelAnimationFrame(this.frame);
    this.plot.destroy();
  }

  private record(telemetry: Telemetry | null): void {
    if (!telemetry) return this.recording.clear();
    const readings = readingsOf(telemetry, this.odometer);
    this.recording.add(telemetry.time, readings);
    this.learn(readings);
    this.present = readings;
    this.schedule();
  }

  /** Handle a robot with other sensors. */
  private learn(sensors: readonly Sensor[]): void {
    const ids = sensors.map(sensorId);
    if (ids.join() === this.known.peek().map(sensorId).join()) return;
    const kept = [...this.chosen.peek()].filter((id) => ids.includes(id));
    const first =
      PLOTTED_AT_FIRST.map((type) => sensors.find(({ device }) => device === type)).find(Boolean) ?? sensors[0];
    this.chosen.value = new Set(kept.length > 0 || !first ? kept : [sensorId(first)]);
    this.known.value = sensors;
  }

  private nameAll(): void {
    const sensors = this.known.value;
    this.dom.setAttribute("aria-label", t("page-sensors-title"));
    this.nothing.textContent = t("page-sensors-nothing");
    this.nothing.hidden = sensors.length > 0;
    this.save.textContent = t("page-sensors-save");
    this.summaryTitle.textContent = t("page-sensors-summary");
    for (const part of [this.readings.dom, this.save, this.summaryTitle]) part.hidden = sensors.length === 0;
    this.readings.list(sensors, this.chosen.peek(), (id, on) => this.choose(id, on));
    this.schedule();
  }

  private choose(id: string, on: boolean): void {
    const chosen = new Set(this.chosen.value);
    if (on) chosen.add(id);
    else chosen.delete(id);
    this.chosen.value = chosen;
  }

  /** Plot what the user asked for elsewhere, as soon as its sensors are known. */
  private plotWanted(): void {
    const { value: wanted } = this.wanted;
    if (!wanted) return;
    const found = this.known.value.filter((sensor) => measures(wanted, sensor));
    if (found.length === 0) return;
    this.chosen.value = new Set(found.map(sensorId));
    this.readings.tick(this.chosen.value);
    this.wanted.value = null;
  }

  private plotted(): Sensor[] {
    return this.known.value.filter((sensor) => this.chosen.value.has(sensorId(sensor)));
  }

  /** Recreate the plot when the sensors, language or theme change. */
  private followPlot(): void {
    void [this.known.value, this.chosen.value, language.value, preferences.value.theme, this.visibility.visible.value];
    this.replot();
  }

  private makePlot(sensors: readonly Sensor[]): void {
    this.outdated = false;
    this.summarised = 0;
    this.plot.choose(sensors);
    this.picture.setAttribute("aria-label", t("page-sensors-plot", { sensors: sensors.map(sensorName).join(", ") }));
  }

  /** A hidden plot has no size and is not drawn; it is redrawn when it is shown again. */
  private schedule(): void {
    if (!this.visibility.visible.peek()) return;
    this.frame ||= requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.frame = 0;
    if (now - this.drawn < DRAWING_PERIOD) return this.schedule();
    this.drawn = now;
    this.readings.show(this.shown());
    const plotted = this.plotted();
    if (this.outdated) this.makePlot(plotted);
    const { times, readings } = this.toPlot(plotted.map(sensorId));
    this.plot.draw(times, readings, this.context.running.past.peek()?.time ?? null);
    if (now - this.summarised < SUMMARY_PERIOD) return;
    this.summarised = now;
    this.summarise(plotted, readings);
  }

  /** The readings at present, or those of the moment that the user looks back at. */
  private shown(): readonly Sensor[] {
    const { running } = this.context;
    const past = running.past.peek();
    if (!past) return this.present;
    return past.telemetry ? pastReadingsOf(past.telemetry, running.wayUntil(past.time)) : [];
  }

  /** The last minute, or that around the moment that the user looks back at. */
  private toPlot(ids: readonly string[]): { times: number[]; readings: Reading[][] } {
    const past = this.context.running.past.peek();
    if (!past) return this.recording.last(SHOWN_SECONDS, ids);
    return this.recording.around(past.time, SHOWN_SECONDS, ids, this.shown());
  }

  /** The plot as a table, for screen readers. */
  private summarise(sensors: readonly Sensor[], readings: readonly Reading[][]): void {
    const rows = sensors.map((sensor, index): Row => {
      const measured = (readings[index] ?? []).filter((value) => value !== null);
      if (measured.length === 0) return [sensorName(sensor), "–", "–", "–"];
      const lowest = measured.reduce((a, b) => Math.min(a, b));
      const highest = measured.reduce((a, b) => Math.max(a, b));
      const mean = measured.reduce((a, b) => a + b) / measured.length;
      return [sensorName(sensor), ...[lowest, highest, mean].map((value) => readingText(sensor, value))];
    });
    const columns = ["page-sensors-sensor", "page-sensors-lowest", "page-sensors-highest", "page-sensors-mean"].map(
      (word) => t(word),
    );
    this.summary.show(t("page-sensors-summary"), columns, rows, 0);
  }

  private download(): void {
    download("sensors.csv", "text/csv", this.recording.csv());
  }
}

/** The robot's sensors; `wanted` is what to plot next. */
export function createSensors(context: Context, wanted: Signal<Measure | null>): SensorsIsland {
  return new Sensors(context, wanted);
}
