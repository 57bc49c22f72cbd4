/** What a function can be tried with: an input for each of its parameters, as its block has a field. */

import type { Allowed } from "../blocks/fields";
import type { OwnBlockPreview } from "../messages";

export type Kind = "number" | "range" | "angle" | "text" | "choice" | "colour" | "tag" | "truth" | "list";

/** A parameter; its value is written as a person does. */
export interface Argument {
  readonly name: string;
  readonly kind: Kind;
  readonly allowed: Allowed;
  /** What stands in its field at first. */
  readonly initial: string;
}

interface Entry {
  readonly name?: string;
  readonly field?: Allowed;
}
interface Shadow {
  readonly type: string;
  readonly fields?: Readonly<Record<string, unknown>>;
}

const KINDS: Readonly<Record<string, Kind>> = {
  math_number: "number",
  lb_slider: "range",
  lb_angle: "angle",
  lb_choice: "choice",
  lb_colour: "colour",
  lb_tag: "tag",
  logic_boolean: "truth",
};

/** The parameters of a function by its preview; what has no field is a list. */
export function argumentsOf({ definition, block }: OwnBlockPreview): Argument[] {
  const inputs = (block["inputs"] ?? {}) as Readonly<Record<string, { readonly shadow?: Shadow }>>;
  const entries = (definition["args0"] ?? []) as readonly Entry[];
  return entries.map(({ name = "", field: allowed = {} }) => {
    const shadow = inputs[name]?.shadow;
    const initial = String(Object.values(shadow?.fields ?? {})[0] ?? "[]");
    return { name, allowed, initial, kind: shadow ? (KINDS[shadow.type] ?? "text") : "list" };
  });
}

/** What was written as a value of JSON; undefined where it is none of that kind. */
export function valueOf({ kind }: Argument, written: string): unknown {
  switch (kind) {
    case "number":
    case "range":
    case "angle":
      return written.trim() && Number.isFinite(Number(written)) ? Number(written) : undefined;
    case "tag":
      return /^\d+$/.test(written) ? Number(written) : written;
    case "truth":
      return written === "TRUE";
    case "list":
      return listOf(written);
    default:
      return written;
  }
}

function listOf(written: string): unknown[] | undefined {
  try {
    const found: unknown = JSON.parse(written);
    return Array.isArray(found) ? found : undefined;
  } catch {
    return undefined;
  }
}
