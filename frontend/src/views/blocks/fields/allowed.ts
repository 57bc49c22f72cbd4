/** The limits and options of a parameter, for its field. */

import type * as Blockly from "blockly/core";

/** An option: its label and its value. */
type Choice = readonly [label: string, value: string];

/** Limits of a number, or options; missing ones are unlimited. */
export interface Allowed {
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly options?: readonly Choice[];
}

/** A block's definition, with the server's additions to Blockly's format. */
export interface Definition {
  readonly type: string;
  readonly args0?: readonly { readonly name?: string; readonly field?: Allowed }[];
}

const FREE: Allowed = {};
const known = new Map<string, Allowed>();

/** Store the limits of these blocks' parameters; those of other blocks are kept. */
export function learnAllowed(definitions: readonly Definition[]): void {
  for (const { type, args0 = [] } of definitions) {
    for (const { name = "", field = FREE } of args0) known.set(`${type} ${name}`, field);
  }
}

/** The limits and options of a field's parameter. */
export function allowedAt(field: Blockly.Field): Allowed {
  const place = field.getSourceBlock()?.outputConnection?.targetConnection;
  const name = place?.getParentInput()?.name ?? "";
  return known.get(`${place?.getSourceBlock().type} ${name}`) ?? FREE;
}
