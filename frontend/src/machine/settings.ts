/** What is set of real robots and of perception, on the machine that LearnBlock runs on. */

import { signal } from "@preact/signals";

import type { Connection } from "../connection";
import type { FromPage, Setting, SettingsTable } from "../messages";

/** In place of a robot's name. */
export const PERCEPTION = "";

export type Values = Readonly<Record<string, unknown>>;

const REQUESTS = ["ReadSettings", "ChangeSettings"] as const satisfies readonly FromPage["kind"][];

export class MachineSettings {
  /** The table that was told last; null until then. */
  readonly table = signal<SettingsTable | null>(null);
  /** Why the server refused what was asked last. */
  readonly refusal = signal("");

  constructor(private readonly connection: Connection) {
    connection.on("SettingsTable", (table) => (this.table.value = table));
    connection.onRefused(REQUESTS, (reason) => (this.refusal.value = reason));
  }

  read(robot: string): void {
    this.refusal.value = "";
    this.table.value = null;
    this.connection.send({ kind: "ReadSettings", robot });
  }

  change(robot: string, values: Values, agreed: boolean): void {
    this.refusal.value = "";
    this.connection.send({ kind: "ChangeSettings", robot, values, agreed });
  }
}

/** The values that differ from those that are set. */
export function changes(settings: readonly Setting[], values: Values): Values {
  const changed = settings.filter(({ name, value }) => JSON.stringify(values[name]) !== JSON.stringify(value));
  return Object.fromEntries(changed.map(({ name }) => [name, values[name]]));
}

export function valuesOf(settings: readonly Setting[]): Values {
  return Object.fromEntries(settings.map(({ name, value }) => [name, value]));
}

/** What a field's text means; what cannot be is left for the server to tell. */
export function valueOf({ sort, choices = [], value, default: usual }: Setting, text: string): unknown {
  if (sort === "number" || sort === "whole") return numberOf(text, choices[0]);
  if (sort === "list") return listOf(text, [value, usual].flat().some((one) => typeof one === "number"));
  return text;
}

/** An empty field is the word for none, if there is one. */
function numberOf(text: string, none: string | undefined): unknown {
  if (text.trim() === "") return none ?? text;
  return Number.isNaN(Number(text)) ? text : Number(text);
}

function listOf(text: string, numbers: boolean): unknown[] {
  const lines = text.split("\n").filter((line) => line.trim());
  return numbers ? lines.map((line) => numberOf(line, undefined)) : lines.map((line) => line.trim());
}

/** What a field shows of a value. */
export function textOf({ sort, choices = [] }: Setting, value: unknown): string {
  if (sort === "list") return Array.isArray(value) ? value.join("\n") : "";
  return (sort === "number" || sort === "whole") && value === choices[0] ? "" : String(value ?? "");
}
