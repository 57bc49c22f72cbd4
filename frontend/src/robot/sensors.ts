/** What the robot senses: numbers, bars, a plot of the last minute, and a file of all of it. */

import "./panel.css";
import "./sensors.css";

import { effect, signal } from "@preact/signals";

import type { Context } from "../context";
import { language, t } from "../i18n";
import type { Island } from "../island";
import type { Telemetry } from "../messages";
import { preferences } from "../preferences";
import { button, download, element } from "./elements";
import { Plot, SHOWN_SECONDS } from "./plot";
import { readingText, sensorName } from "./quantities";
import { Readings } from "./readings";
import { Recording, type Reading } from "./recording";
import { createTable, type Row } from "./table";
import { watchVisibility } from "./visibility";

export interface SensorsIsland extends Island {
  resize(): void;
}

/** Milliseconds between two drawings. */
const DRAWING_PERIOD = 66;
/** Milliseconds between two looks at the table of lowest and highest. */
const SUMMARY_PERIOD = 1000;
/** Sensors that are plotted before the user has chosen. */
const PLOTTED_AT_FIRST = ["Distance front 1", "Ground left", "Ground central", "Gyroscope"];

class Sensors implements SensorsIsland {
  private readonly nothing = element("p", { class: "nothing" });
  private readonly readings = new Readings();
  private readonly picture = element("div", { class: "plot", role: "img" });
  private readonly summary = createTable();
  private readonly summaryTitle = element("summary");
  private readonly save = button("tool", () => this.download());
  readonly dom = element("section", { class: "robot-panel sensors scroll", tabindex: "0" });

  private readonly recording = new Recording();
  private readonly plot = new Plot(this.picture);
  private readonly visibility = watchVisibility(this.dom);
  /** Every sensor, and those the user wants to see plotted. */
  private readonly known = signal<readonly string[]>([]);
  private readonly chosen = signal<ReadonlySet<string>>(new Set());
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly replot = () => {
    this.outdated = true;
    this.schedule();
  };
  private readonly disposers: (() => void)[];
  private outdated = true;
  private frame = 0;
  private drawn = 0;
  private summarised = 0;

  constructor(private readonly context: Context) {
    const details = element("details", {}, this.summaryTitle, this.summary.dom);
    const tools = element("div", { class: "tools" }, this.save);
    this.dom.append(this.nothing, this.readings.dom, this.picture, details, tools);
    this.dark.addEventListener("change", this.replot);
    this.disposers = [
      effect(() => this.record(context.running.telemetry.value)),
      effect(() => this.nameAll()),
      effect(() => this.followPlot()),
    ];
  }

  resize(): void {
    this.plot.resize();
  }

  destroy(): void {
    for (const dispose of this.disposers) dispose();
    this.dark.removeEventListener("change", this.replot);
    this.visibility.destroy();
    cancelAnimationFrame(this.frame);
    this.plot.destroy();
  }

  private record(telemetry: Telemetry | null): void {
    if (!telemetry) return this.recording.clear();
    this.recording.add(telemetry.time, telemetry.sensors ?? {});
    this.learn(Object.keys(telemetry.sensors ?? {}));
    this.schedule();
  }

  /** Another robot has other sensors. */
  private learn(sensors: readonly string[]): void {
    if (sensors.join() === this.known.peek().join()) return;
    const kept = [...this.chosen.peek()].filter((sensor) => sensors.includes(sensor));
    const first = PLOTTED_AT_FIRST.find((sensor) => sensors.includes(sensor)) ?? sensors[0];
    this.chosen.value = new Set(kept.length > 0 || !first ? kept : [first]);
    this.known.value = sensors;
  }

  private nameAll(): void {
    const sensors = this.known.value;
    this.dom.setAttribute("aria-label", t("sensors.title"));
    this.nothing.textContent = t("sensors.nothing");
    this.nothing.hidden = sensors.length > 0;
    this.save.textContent = t("sensors.save");
    this.summaryTitle.textContent = t("sensors.summary");
    for (const part of [this.readings.dom, this.save, this.summaryTitle]) part.hidden = sensors.length === 0;
    this.readings.list(sensors, this.chosen.peek(), (sensor, on) => this.choose(sensor, on));
    this.schedule();
  }

  private choose(sensor: string, on: boolean): void {
    const chosen = new Set(this.chosen.value);
    if (on) chosen.add(sensor);
    else chosen.delete(sensor);
    this.chosen.value = chosen;
  }

  private plotted(): string[] {
    return this.known.value.filter((sensor) => this.chosen.value.has(sensor));
  }

  /** Other sensors, another language and other colours need another plot. */
  private followPlot(): void {
    void [this.known.value, this.chosen.value, language.value, preferences.value.theme, this.visibility.visible.value];
    this.replot();
  }

  private makePlot(names: readonly string[]): void {
    this.outdated = false;
    this.summarised = 0;
    this.plot.choose(names);
    this.picture.setAttribute("aria-label", t("sensors.plot", { sensors: names.map(sensorName).join(", ") }));
  }

  /** While it is hidden nothing is drawn, as it has no size; what is shown again is drawn anew. */
  private schedule(): void {
    if (!this.visibility.visible.peek()) return;
    this.frame ||= requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.frame = 0;
    if (now - this.drawn < DRAWING_PERIOD) return this.schedule();
    this.drawn = now;
    this.readings.show(this.context.running.telemetry.peek()?.sensors ?? {});
    const names = this.plotted();
    if (this.outdated) this.makePlot(names);
    const { times, readings } = this.recording.last(SHOWN_SECONDS, names);
    this.plot.draw(times, readings);
    if (now - this.summarised < SUMMARY_PERIOD) return;
    this.summarised = now;
    this.summarise(names, readings);
  }

  /** The plot for those who do not see it. */
  private summarise(names: readonly string[], readings: readonly Reading[][]): void {
    const rows = names.map((name, index): Row => {
      const measured = (readings[index] ?? []).filter((value) => value !== null);
      if (measured.length === 0) return [sensorName(name), "–", "–", "–"];
      const lowest = measured.reduce((a, b) => Math.min(a, b));
      const highest = measured.reduce((a, b) => Math.max(a, b));
      const mean = measured.reduce((a, b) => a + b) / measured.length;
      return [sensorName(name), ...[lowest, highest, mean].map((value) => readingText(name, value))];
    });
    const columns = ["sensors.sensor", "sensors.lowest", "sensors.highest", "sensors.mean"].map((word) => t(word));
    this.summary.show(t("sensors.summary"), columns, rows, 0);
  }

  private download(): void {
    download("sensors.csv", "text/csv", this.recording.csv());
  }
}

/** The robot's sensors. */
export function createSensors(context: Context): SensorsIsland {
  return new Sensors(context);
}
