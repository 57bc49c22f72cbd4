/** What a parameter allows, for the field that stands in its place. */

import type * as Blockly from "blockly/core";

/** A choice: what is shown for it, and its value. */
type Choice = readonly [label: string, value: string];

/** Limits of a number, or what there is to choose from; what is not said is free. */
export interface Allowed {
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly options?: readonly Choice[];
}

/** A block's definition, in which our server says more of an input than Blockly asks for. */
export interface Definition {
  readonly type: string;
  readonly args0?: readonly { readonly name?: string; readonly field?: Allowed }[];
}

const FREE: Allowed = {};
const known = new Map<string, Allowed>();

/** Learn what the parameters of these blocks allow; of other blocks what was learned before stays. */
export function learnAllowed(definitions: readonly Definition[]): void {
  for (const { type, args0 = [] } of definitions) {
    for (const { name = "", field = FREE } of args0) known.set(`${type} ${name}`, field);
  }
}

/** What is allowed where a field stands. */
export function allowedAt(field: Blockly.Field): Allowed {
  const place = field.getSourceBlock()?.outputConnection?.targetConnection;
  const name = place?.getParentInput()?.name ?? "";
  return known.get(`${place?.getSourceBlock().type} ${name}`) ?? FREE;
}
