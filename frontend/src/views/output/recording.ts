/** The sensors' readings, kept for plotting and for a file. */

import type { Sensor } from "../../protocol/messages";
import { quantityOf, sensorId } from "./quantities";

export type Reading = number | null;

interface Column {
  readonly sensor: Sensor;
  readings: Reading[];
}

/** Half an hour at 20 per second; after that, the older half is dropped. */
const MOST_SAMPLES = 36_000;

/** The title of a column: type and key of the device, position and number, unit. */
function title(sensor: Sensor): string {
  const { device, key, place, number } = sensor;
  const { unit } = quantityOf(sensor);
  return [device, key, place, number, unit && `(${unit})`].filter(Boolean).join(" ");
}

function asReading(value: number | boolean | null): Reading {
  return value === null ? null : Number(value);
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
      readings.push(asReading(now.get(id)?.value ?? null));
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

  /**
   * Times and readings around a moment, of `seconds`; later ones are null.
   *
   * @param now the readings of the moment itself.
   */
  around(
    moment: number,
    seconds: number,
    ids: readonly string[],
    now: readonly Sensor[],
  ): { times: number[]; readings: Reading[][] } {
    const end = Math.max(moment, Math.min(this.times.at(-1) ?? moment, moment + seconds / 2));
    const first = this.times.findLastIndex((time) => time < end - seconds) + 1;
    const at = this.times.findLastIndex((time) => time < moment) + 1;
    const after = this.times.slice(at).filter((time) => time > moment && time <= end);
    const values = new Map(now.map((sensor) => [sensorId(sensor), sensor.value]));
    return {
      times: [...this.times.slice(first, at), moment, ...after],
      readings: ids.map((id) => [
        ...(this.columns.get(id)?.readings.slice(first, at) ?? []),
        asReading(values.get(id) ?? null),
        ...after.map(() => null),
      ]),
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
