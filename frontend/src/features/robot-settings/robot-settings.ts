/** The settings of real robots and camera recognition on the server's machine. */

import { signal } from "@preact/signals";

import { DialogRequests } from "../../model/dialog-requests";
import type { Connection } from "../../protocol/connection";
import type { Setting, SettingsTable } from "../../protocol/messages";

/** In place of a robot's name. */
export const PERCEPTION = "";

export type Values = Readonly<Record<string, unknown>>;

export class RobotSettings {
  /** The table received last; null before the first. */
  readonly table = signal<SettingsTable | null>(null);
  readonly requests: DialogRequests;

  constructor(connection: Connection) {
    this.requests = new DialogRequests(connection);
    connection.on("SettingsTable", (table) => (this.table.value = table));
  }

  read(robot: string): void {
    this.table.value = null;
    void this.requests.ask({ kind: "ReadSettings", robot });
  }

  change(robot: string, values: Values, agreed: boolean): void {
    void this.requests.ask({ kind: "ChangeSettings", robot, values, agreed });
  }
}

declare module "../../model/page" {
  interface Page {
    readonly robotSettings: RobotSettings;
  }
}

/** The values that differ from the saved ones. */
export function changes(settings: readonly Setting[], values: Values): Values {
  const changed = settings.filter(({ name, value }) => JSON.stringify(values[name]) !== JSON.stringify(value));
  return Object.fromEntries(changed.map(({ name }) => [name, values[name]]));
}

export function valuesOf(settings: readonly Setting[]): Values {
  return Object.fromEntries(settings.map(({ name, value }) => [name, value]));
}

/** The value of a field's text; invalid text is left for the server to refuse. */
export function parseValue({ sort, choices = [], value, default: usual }: Setting, text: string): unknown {
  if (sort === "number" || sort === "whole") return numberOf(text, choices[0]);
  if (sort === "list") return listOf(text, hasNumbers([value, usual]));
  return text;
}

function hasNumbers(lists: readonly unknown[]): boolean {
  return lists.flat().some((one) => typeof one === "number");
}

/** An empty field means the setting's word for none, if it has one. */
function numberOf(text: string, none: string | undefined): unknown {
  if (text.trim() === "") return none ?? text;
  return Number.isNaN(Number(text)) ? text : Number(text);
}

function listOf(text: string, numbers: boolean): unknown[] {
  const lines = text.split("\n").filter((line) => line.trim());
  return numbers ? lines.map((line) => numberOf(line, undefined)) : lines.map((line) => line.trim());
}

/** The text that a field shows for a value. */
export function formatValue({ sort, choices = [] }: Setting, value: unknown): string {
  if (sort === "list") return Array.isArray(value) ? value.join("\n") : "";
  return (sort === "number" || sort === "whole") && value === choices[0] ? "" : String(value ?? "");
}

/** What a description says beyond its label, which the command line lacks. */
export function beyond(label: string, description: string): string {
  const begins = description.toLowerCase().startsWith(label.toLowerCase());
  const rest = begins ? description.slice(label.length) : "";
  if (begins && rest === "") return "";
  return /^[\s,;:]/.test(rest) ? rest.replace(/^[\s,;:]+/, "") : description;
}
