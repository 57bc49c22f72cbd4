/** The properties of each sort of object and their bounds, from the schema of world files. */

import type { Sort, Thing } from "../../views/world/plan/sorts";
import schema from "./schema.json";

/** A key of an object with its allowed values. */
export type Field = { readonly key: string; readonly optional: boolean } & (
  | { readonly kind: "number"; readonly least: number; readonly most: number; readonly whole: boolean }
  | { readonly kind: "text"; readonly shortest: number; readonly longest: number }
  | { readonly kind: "choice"; readonly options: readonly string[] }
  | { readonly kind: "numbers"; readonly bounds: readonly (readonly [number, number])[] }
  | { readonly kind: "yes" | "colour" | "points" | "parts" }
);

/** The part of JSON Schema that msgspec writes. */
interface Schema {
  readonly type?: string;
  readonly enum?: readonly string[];
  readonly anyOf?: readonly Schema[];
  readonly minimum?: number;
  readonly maximum?: number;
  readonly minLength?: number;
  readonly maxLength?: number;
  readonly prefixItems?: readonly Schema[];
  readonly items?: Schema | false;
  readonly $ref?: string;
  readonly default?: unknown;
}

interface Table {
  readonly properties: Readonly<Record<string, Schema>>;
}

const TABLES: Readonly<Record<Sort | "world" | "floor" | "part" | "vary", keyof typeof schema>> = {
  line: "Line",
  wall: "Wall",
  box: "Box",
  cylinder: "Cylinder",
  tag: "Tag",
  face: "Face",
  light: "Lamp",
  prop: "Prop",
  start: "Start",
  reach: "Reach",
  follow: "Follow",
  visit: "Visit",
  tour: "Tour",
  stop: "Stop",
  show: "Show",
  avoid: "Avoid",
  world: "WorldFile",
  floor: "Floor",
  part: "Part",
  vary: "Vary",
};

export type TableName = keyof typeof TABLES;

function properties(table: TableName): Table["properties"] {
  return (schema[TABLES[table]] as unknown as Table).properties;
}

/** The fields of a table in the order of its description. */
export function fieldsOf(table: TableName): Field[] {
  return Object.entries(properties(table)).flatMap(([key, found]) => fieldOf(key, found) ?? []);
}

/** The smallest and largest value of a key. */
export function boundsOf(table: TableName, key: string): readonly [number, number] {
  const found = properties(table)[key] ?? {};
  const { minimum = 0, maximum = 0 } = found.anyOf?.[0] ?? found;
  return [minimum, maximum];
}

/** The default values of an object. */
export function defaultsOf(table: TableName): Thing {
  const known = Object.entries(properties(table)).filter(([, found]) => "default" in found);
  return structuredClone(Object.fromEntries(known.map(([key, found]) => [key, found.default])));
}

function fieldOf(key: string, found: Schema): Field | null {
  const choices = found.anyOf ?? [found];
  const optional = choices.some(({ type }) => type === "null");
  const [value = found, other] = choices.filter(({ type }) => type !== "null");
  if (value.enum && other) return { key, optional, kind: "colour" };
  if (value.enum) return { key, optional, kind: "choice", options: value.enum };
  const { minimum: least = 0, maximum: most = 0 } = value;
  switch (value.type) {
    case "number":
    case "integer":
      return { key, optional, kind: "number", least, most, whole: value.type === "integer" };
    case "string":
      return { key, optional, kind: "text", shortest: value.minLength ?? 0, longest: value.maxLength ?? 200 };
    case "boolean":
      return { key, optional, kind: "yes" };
    case "array":
      return listField(key, optional, value);
    default:
      return null;
  }
}

function listField(key: string, optional: boolean, { prefixItems, items }: Schema): Field | null {
  if (prefixItems) {
    const bounds = prefixItems.map(({ minimum = 0, maximum = 0 }) => [minimum, maximum] as const);
    return { key, optional, kind: "numbers", bounds };
  }
  if (!items) return null;
  if (items.prefixItems) return { key, optional, kind: "points" };
  return items.$ref?.endsWith("/Part") ? { key, optional, kind: "parts" } : null;
}
