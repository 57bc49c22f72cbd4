/** The arguments for a test run: an input for each parameter, like the block's fields. */

import type { CustomBlockPreview } from "../../protocol/messages";
import type { Allowed } from "../../views/blocks/fields";

export type Kind = "number" | "range" | "angle" | "text" | "choice" | "colour" | "tag" | "truth" | "list";

/** A parameter, with its value as the user typed it. */
export interface Argument {
  readonly name: string;
  readonly kind: Kind;
  readonly allowed: Allowed;
  /** The initial text of its field. */
  readonly initial: string;
}

interface Entry {
  readonly type?: string;
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
  lb_truth: "truth",
};

/** The parameters in a function's preview; one without a field takes a list. */
export function argumentsOf({ definition, block }: CustomBlockPreview): Argument[] {
  const inputs = (block.inputs ?? {}) as Readonly<Record<string, { readonly shadow?: Shadow }>>;
  // The others show the sign of a number.
  const entries = ((definition.args0 ?? []) as readonly Entry[]).filter(({ type }) => type === "input_value");
  return entries.map(({ name = "", field: allowed = {} }) => {
    const shadow = inputs[name]?.shadow;
    const initial = String(Object.values(shadow?.fields ?? {})[0] ?? "[]");
    return { name, allowed, initial, kind: shadow ? (KINDS[shadow.type] ?? "text") : "list" };
  });
}

/** The typed text as a JSON value; undefined if it does not fit the kind. */
export function parseValue({ kind }: Argument, written: string): unknown {
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
