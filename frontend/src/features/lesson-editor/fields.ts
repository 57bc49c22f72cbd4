/** The kinds of checks and of events, and the values that each takes, from the schema of lessons. */

import { translated } from "../../i18n";
import { type Field, fieldsIn, type Table } from "../../ui/form/schema";
import type { Values } from "../lessons/lesson-edit";
import schema from "./schema.json";

type Tag = "kind" | "event";

/** What every check has; the editor has fields of its own for some of it. */
const COMMON = new Set(["kind", "event", "say", "name", "robot", "optional"]);
const TABLES = Object.values(schema) as unknown as readonly Table[];
/** A check in Python needs a file that the editor doesn't have. */
const WITHOUT_FORM = new Set(["python"]);

/** A kind of check in words; a name that the teacher has given as it is. */
export function kindWords(name: string): string {
  return translated(`page-maker-kind-${name.replaceAll("_", "-")}`, name);
}

/** The kinds of checks, or of events. */
export function kindsOf(tag: Tag): readonly string[] {
  return TABLES.flatMap(({ properties }) => properties[tag]?.enum ?? []).filter((kind) => !WITHOUT_FORM.has(kind));
}

export function fieldsOf(tag: Tag, kind: unknown): readonly Field[] {
  const table = TABLES.find(({ properties }) => properties[tag]?.enum?.[0] === kind);
  return table ? fieldsIn(table).filter(({ key }) => !COMMON.has(key)) : [];
}

/** A new check or event of a kind; what has no default is to be filled in. */
export function newOf(tag: Tag, kind: string): Values {
  const needed = fieldsOf(tag, kind).filter(({ optional, initial }) => !optional && initial === undefined);
  return { [tag]: kind, ...Object.fromEntries(needed.map((field) => [field.key, firstValue(field)])) };
}

function firstValue({ shape }: Field): unknown {
  switch (shape.kind) {
    case "number":
      return Math.max(0, shape.least ?? 0);
    case "union":
      return newOf("event", "collision");
    case "list":
      return shape.item.kind === "union" ? [newOf("event", "stands"), newOf("event", "stands")] : [];
    default:
      return "";
  }
}
