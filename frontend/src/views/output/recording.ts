/** The sensors' readings, kept for plotting and for a file. */

import type { Sensor } from "../../protocol/messages";
import { sensorId } from "./quantities";

export type Reading = number | null;

interface Column {
  readonly sensor: Sensor;
  readings: Reading[];
}

/** Half an hour at 20 per second; after that, the older half is dropped. */
const MOST_SAMPLES = 36_000;

/** The title of a column: type and key of the device, position and number, unit. */
function title({ device, key, place, number, unit }: Sensor): string {
  return [device, key, place, number, unit && `(${unit})`].filter(Boolean).join(" ");
}

/** Readings over the robot's time, in seconds. */
export class Recording {
  private times: number[] = [];
  private columns = new Map<string, Column>();

  /** Add the readings of a moment; a time before the last one begins a new recording. */
  add(time: number, sensors: readonly Sensor[]): void {
    const last = this.times.at(-1) ?? -Infinity;
    if (time === last) return;
    if (time < last) this.clear();
    const now = new Map(sensors.map((sensor) => [sensorId(sensor), sensor]));
    for (const [id, sensor] of now) this.addColumn(id, sensor);
    this.times.push(time);
    for (const [id, { readings }] of this.columns) {
      const value = now.get(id)?.value ?? null;
      readings.push(value === null ? null : Number(value));
    }
    if (this.times.length >= MOST_SAMPLES) this.forgetHalf();
  }

  clear(): void {
    this.times = [];
    this.columns.clear();
  }

  /** Times, and the readings of each sensor by its id, of the last `seconds`. */
  last(seconds: number, ids: readonly string[]): { times: number[]; readings: Reading[][] } {
    const end = this.times.at(-1) ?? 0;
    const from = this.times.findLastIndex((time) => time < end - seconds) + 1;
    return {
      times: this.times.slice(from),
      readings: ids.map((id) => this.columns.get(id)?.readings.slice(from) ?? []),
    };
  }

  /** As comma-separated values: a column for the time and one for each sensor. */
  csv(): string {
    const columns = [...this.columns.values()];
    const rows = this.times.map((time, row) => [time, ...columns.map(({ readings }) => readings[row] ?? "")]);
    return (
      [["time (s)", ...columns.map(({ sensor }) => title(sensor))], ...rows].map((row) => row.join(",")).join("\r\n") +
      "\r\n"
    );
  }

  private addColumn(id: string, sensor: Sensor): void {
    if (!this.columns.has(id)) this.columns.set(id, { sensor, readings: this.times.map(() => null) });
  }

  private forgetHalf(): void {
    const half = MOST_SAMPLES / 2;
    this.times = this.times.slice(half);
    for (const column of this.columns.values()) column.readings = column.readings.slice(half);
  }
}
