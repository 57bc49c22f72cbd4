/** The kinds of checks and of events, and the values that each takes, from the schema of lessons. */

import { translated } from "../../i18n";
import type { Values } from "../lessons/lesson-edit";
import schema from "./schema.json";

/** A value of a check or of an event. */
export type Field = { readonly key: string; readonly optional: boolean; readonly initial: unknown } & (
  | { readonly kind: "number"; readonly least: number; readonly most: number; readonly whole: boolean }
  | { readonly kind: "text" | "texts" | "event" | "events" }
  | { readonly kind: "choice"; readonly options: readonly string[] }
);

/** The part of JSON Schema that msgspec writes. */
interface Schema {
  readonly type?: string;
  readonly enum?: readonly string[];
  readonly anyOf?: readonly Schema[];
  readonly minimum?: number;
  readonly maximum?: number;
  readonly items?: Schema;
  readonly $ref?: string;
  readonly default?: unknown;
}

type Tag = "kind" | "event";

/** What every check has; the editor has fields of its own for some of it. */
const COMMON = new Set(["kind", "event", "say", "name", "robot", "optional"]);
const TABLES = Object.values(schema) as unknown as readonly { readonly properties: Record<string, Schema> }[];
/** A check in Python needs a file that the editor doesn't have. */
const WITHOUT_FORM = new Set(["python"]);

/** A kind of check in words; a name that the teacher has given as it is. */
export function kindWords(name: string): string {
  return translated(`page-maker-kind-${name.replace("_", "-")}`, name);
}

/** The kinds of checks, or of events. */
export function kindsOf(tag: Tag): readonly string[] {
  return TABLES.flatMap(({ properties }) => properties[tag]?.enum ?? []).filter((kind) => !WITHOUT_FORM.has(kind));
}

export function fieldsOf(tag: Tag, kind: unknown): readonly Field[] {
  const table = TABLES.find(({ properties }) => properties[tag]?.enum?.[0] === kind);
  return Object.entries(table?.properties ?? {})
    .filter(([key]) => !COMMON.has(key))
    .flatMap(([key, found]) => fieldOf(key, found) ?? []);
}

/** A new check or event of a kind; what has no default is to be filled in. */
export function newOf(tag: Tag, kind: string): Values {
  const needed = fieldsOf(tag, kind).filter(({ optional, initial }) => !optional && initial === undefined);
  return { [tag]: kind, ...Object.fromEntries(needed.map((field) => [field.key, firstValue(field)])) };
}

function firstValue(field: Field): unknown {
  switch (field.kind) {
    case "number":
      return Math.max(0, field.least);
    case "event":
      return newOf("event", "collision");
    case "events":
      return [newOf("event", "stands"), newOf("event", "stands")];
    case "texts":
      return [];
    default:
      return "";
  }
}

function fieldOf(key: string, found: Schema): Field | null {
  const choices = found.anyOf ?? [found];
  const optional = choices.some(({ type }) => type === "null");
  const [value = found] = choices.filter(({ type }) => type !== "null");
  const common = { key, optional, initial: found.default };
  if (value.$ref) return { ...common, kind: "event" };
  if (value.enum) return { ...common, kind: "choice", options: value.enum };
  const { minimum: least = 0, maximum: most = 0 } = value;
  switch (value.type) {
    case "number":
    case "integer":
      return { ...common, kind: "number", least, most, whole: value.type === "integer" };
    case "string":
      return { ...common, kind: "text" };
    case "array":
      return { ...common, kind: value.items?.anyOf ? "events" : "texts" };
    default:
      return null;
  }
}
