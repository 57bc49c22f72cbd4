/** What the sensors measured, kept for plotting and for a file. */

import type { Telemetry } from "../messages";

export type Reading = number | null;
type Sensors = NonNullable<Telemetry["sensors"]>;

/** Half an hour at twenty a second; then the older half is forgotten. */
const MOST_SAMPLES = 36_000;

function reading(value: Sensors[string] | undefined): Reading {
  return typeof value === "boolean" ? Number(value) : (value ?? null);
}

/** Readings over the time of the world, in seconds. */
export class Recording {
  private times: number[] = [];
  private columns = new Map<string, Reading[]>();

  get names(): readonly string[] {
    return [...this.columns.keys()];
  }

  /** A world that begins anew begins a new recording. */
  add(time: number, sensors: Sensors): void {
    const last = this.times.at(-1) ?? -Infinity;
    if (time === last) return;
    if (time < last) this.clear();
    for (const name of Object.keys(sensors)) this.column(name);
    this.times.push(time);
    for (const [name, column] of this.columns) column.push(reading(sensors[name]));
    if (this.times.length >= MOST_SAMPLES) this.forgetHalf();
  }

  clear(): void {
    this.times = [];
    this.columns.clear();
  }

  /** Times, and the readings of each sensor, of the last `seconds`. */
  last(seconds: number, names: readonly string[]): { times: number[]; readings: Reading[][] } {
    const end = this.times.at(-1) ?? 0;
    const from = this.times.findLastIndex((time) => time < end - seconds) + 1;
    return { times: this.times.slice(from), readings: names.map((name) => this.columns.get(name)?.slice(from) ?? []) };
  }

  /** As comma-separated values: a column for the time and one for each sensor. */
  csv(): string {
    const names = this.names;
    const rows = this.times.map((time, row) => [time, ...names.map((name) => this.columns.get(name)?.[row] ?? "")]);
    return [["time (s)", ...names], ...rows].map((row) => row.join(",")).join("\r\n") + "\r\n";
  }

  private column(name: string): Reading[] {
    const known = this.columns.get(name) ?? this.times.map(() => null);
    this.columns.set(name, known);
    return known;
  }

  private forgetHalf(): void {
    const half = MOST_SAMPLES / 2;
    this.times = this.times.slice(half);
    for (const [name, column] of this.columns) this.columns.set(name, column.slice(half));
  }
}
