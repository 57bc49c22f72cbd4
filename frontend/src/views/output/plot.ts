/** A plot of readings over time. */

import "uplot/dist/uPlot.min.css";

import uPlot from "uplot";

import { t } from "../../i18n";
import type { Sensor } from "../../protocol/messages";
import { quantityOf, sensorName } from "./quantities";
import type { Reading } from "./recording";

/** The plotted time span, seconds. */
export const SHOWN_SECONDS = 60;

/** Colours and dashes of the lines; contrast at least 3:1 on both backgrounds. */
const STROKES: readonly (readonly [light: string, dark: string, dash: number[]])[] = [
  ["#2156c4", "#8ab4f8", []],
  ["#b3261e", "#ff9a90", [8, 4]],
  ["#176f31", "#6fdc8f", [2, 3]],
  ["#8a1a9b", "#d9a0f5", [10, 3, 2, 3]],
  ["#7d5200", "#f4c95d", [5, 5]],
  ["#0f5f7a", "#7fd4ef", [14, 4]],
];

interface Colours {
  readonly text: string;
  readonly grid: string;
  readonly dark: boolean;
}

function coloursOf(element: Element): Colours {
  const style = getComputedStyle(element);
  const value = (name: string) => style.getPropertyValue(name).trim();
  return { text: value("--text-dim"), grid: value("--border"), dark: style.colorScheme === "dark" };
}

function series(sensor: Sensor, index: number, dark: boolean): uPlot.Series {
  const [light, darker, dash] = STROKES[index % STROKES.length] ?? STROKES[0]!;
  return {
    label: sensorName(sensor),
    scale: scaleOf(sensor),
    stroke: dark ? darker : light,
    dash,
    width: 2,
    points: { show: false },
  };
}

/** Sensors of one unit share a scale. */
function scaleOf(sensor: Sensor): string {
  return quantityOf(sensor).unit || sensor.device;
}

/** The first two scales have an axis, one on each side; there is no room for more. */
function axes(sensors: readonly Sensor[], { text, grid }: Colours): uPlot.Axis[] {
  const scales = [...new Set(sensors.map(scaleOf))].slice(0, 2);
  const common = { stroke: text, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid } };
  const time = { ...common, values: (_: uPlot, ticks: number[]) => ticks.map((tick) => `${tick} s`) };
  return [
    time,
    ...scales.map(
      (scale, index) =>
        ({ ...common, scale, size: 56, side: index === 0 ? 3 : 1, label: scale, labelSize: 16 }) as uPlot.Axis,
    ),
  ];
}

/** A plot of some sensors. */
export class Plot {
  private plot: uPlot | null = null;
  /** The moment that the user looks back at, in s. */
  private moment: number | null = null;

  constructor(readonly dom: HTMLElement) {}

  /** Replace the plot when the sensors, colours or language change. */
  choose(sensors: readonly Sensor[]): void {
    this.plot?.destroy();
    this.plot = null;
    this.dom.hidden = sensors.length === 0;
    if (sensors.length === 0) return;
    const colours = coloursOf(this.dom);
    const options: uPlot.Options = {
      ...this.size(),
      series: [
        { label: t("page-sensors-time") },
        ...sensors.map((sensor, index) => series(sensor, index, colours.dark)),
      ],
      axes: axes(sensors, colours),
      scales: { x: { time: false } },
      legend: { live: false },
      cursor: { drag: { x: false, y: false } },
      hooks: { draw: [(plot) => this.markMoment(plot, colours.text)] },
    };
    this.plot = new uPlot(options, [[], ...sensors.map(() => [])], this.dom);
  }

  /** Draw the readings, and a line at a moment in s that is looked back at. */
  draw(times: number[], readings: Reading[][], moment: number | null): void {
    this.moment = moment;
    this.plot?.setData([times, ...readings]);
  }

  resize(): void {
    this.plot?.setSize(this.size());
  }

  destroy(): void {
    this.plot?.destroy();
  }

  private markMoment(plot: uPlot, color: string): void {
    if (this.moment === null) return;
    const x = plot.valToPos(this.moment, "x", true);
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = color;
    ctx.lineWidth = 2 * devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  private size(): { width: number; height: number } {
    const width = Math.max(160, this.dom.clientWidth - 8);
    return { width, height: Math.max(140, Math.min(260, width * 0.5)) };
  }
}
