/** The fields that a form draws, and their descriptions in a JSON Schema that msgspec has written. */

/** What a field holds, and what is allowed in it. */
export type Shape =
  | NumberShape
  | TextShape
  | { readonly kind: "choice"; readonly options: readonly string[] }
  /** Numbers that belong together, such as a pose, each with its bounds. */
  | { readonly kind: "numbers"; readonly bounds: readonly Bounds[] }
  | { readonly kind: "list"; readonly item: Shape; readonly fewest: number; readonly most: number }
  /** The values of a table. */
  | { readonly kind: "record"; readonly table: string }
  /** The values of one of several tables; its tag says which. */
  | { readonly kind: "union"; readonly tag: string }
  | { readonly kind: "yes" }
  | { readonly kind: "colour" };

export interface NumberShape {
  readonly kind: "number";
  readonly least?: number;
  readonly most?: number;
  /** 1 for whole numbers; any number without it. */
  readonly step?: number;
}

export interface TextShape {
  readonly kind: "text";
  readonly shortest?: number;
  readonly longest?: number;
  /** The lines of a long text. */
  readonly rows?: number;
  /** Whether it is a program. */
  readonly isCode?: boolean;
  /** Whether the text is reported only when the user leaves the field. */
  readonly isCommitted?: boolean;
}

export type Bounds = readonly [least: number, most: number];

/** A value of a table. */
export interface Field {
  readonly key: string;
  readonly optional: boolean;
  readonly initial: unknown;
  readonly shape: Shape;
}

/** The part of JSON Schema that msgspec writes. */
export interface Schema {
  readonly type?: string;
  readonly enum?: readonly string[];
  readonly anyOf?: readonly Schema[];
  readonly discriminator?: { readonly propertyName: string };
  readonly minimum?: number;
  readonly maximum?: number;
  readonly minLength?: number;
  readonly maxLength?: number;
  readonly minItems?: number;
  readonly maxItems?: number;
  readonly prefixItems?: readonly Schema[];
  readonly items?: Schema | false;
  readonly $ref?: string;
  readonly default?: unknown;
}

export interface Table {
  readonly properties: Readonly<Record<string, Schema>>;
}

/** The fields of a table in the order of its description. */
export function fieldsIn({ properties }: Table): Field[] {
  return Object.entries(properties).flatMap(([key, schema]) => {
    const shape = shapeOf(schema);
    const optional = alternatives(schema).some(({ type }) => type === "null");
    return shape ? [{ key, optional, initial: schema.default, shape }] : [];
  });
}

/** The default values of a table. */
export function defaultsIn({ properties }: Table): Record<string, unknown> {
  const known = Object.entries(properties).filter(([, schema]) => "default" in schema);
  return structuredClone(Object.fromEntries(known.map(([key, schema]) => [key, schema.default])));
}

/** The smallest and largest number of a schema. */
export function boundsIn(schema: Schema): Bounds {
  const { minimum = 0, maximum = 0 } = alternatives(schema)[0] ?? schema;
  return [minimum, maximum];
}

function alternatives(schema: Schema): readonly Schema[] {
  return schema.anyOf ?? [schema];
}

/** @returns null if no field can hold the value. */
function shapeOf(schema: Schema): Shape | null {
  if (schema.discriminator) return { kind: "union", tag: schema.discriminator.propertyName };
  const [value, other] = alternatives(schema).filter(({ type }) => type !== "null");
  if (!value) return null;
  if (value.enum && other?.enum) return { kind: "choice", options: [...value.enum, ...other.enum] };
  // One of the names, or red, green and blue.
  if (value.enum && other) return { kind: "colour" };
  if (value.enum) return { kind: "choice", options: value.enum };
  if (value.$ref) return { kind: "record", table: value.$ref.split("/").at(-1) ?? "" };
  return other ? null : plainShape(value);
}

function plainShape(value: Schema): Shape | null {
  const [least, most] = boundsIn(value);
  switch (value.type) {
    case "number":
      return { kind: "number", least, most };
    case "integer":
      return { kind: "number", least, most, step: 1 };
    case "string":
      return { kind: "text", shortest: value.minLength ?? 0, longest: value.maxLength ?? 200 };
    case "boolean":
      return { kind: "yes" };
    case "array":
      return listShape(value);
    default:
      return null;
  }
}

function listShape({ prefixItems, items, minItems = 0, maxItems = 1000 }: Schema): Shape | null {
  if (prefixItems) return { kind: "numbers", bounds: prefixItems.map(boundsIn) };
  const item = items ? shapeOf(items) : null;
  return item && { kind: "list", item, fewest: minItems, most: maxItems };
}
