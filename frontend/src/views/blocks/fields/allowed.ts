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
  /** Whether other texts are possible, too. */
  readonly open?: boolean;
}

/** A block's definition, with the server's additions to Blockly's format. */
export interface Definition {
  readonly type: string;
  readonly message0?: string;
  readonly args0?: readonly Partial<Parameter>[];
}

/** A parameter of a skill's block. */
export interface Parameter {
  readonly name: string;
  /** Its name for readers, and its type; only a skill's parameters have them. */
  readonly label: string;
  readonly kind: string;
  /** What follows it in the sentence, such as "mm/s". */
  readonly unit?: string;
  readonly field?: Allowed;
}

const FREE: Allowed = {};
const known = new Map<string, Allowed>();
const parameters = new Map<string, readonly Parameter[]>();

/** Store the limits of these blocks' parameters; those of other blocks are kept. */
export function learnAllowed(definitions: readonly Definition[]): void {
  for (const { type, args0 = [] } of definitions) {
    for (const { name = "", field = FREE } of args0) known.set(`${type} ${name}`, field);
    parameters.set(
      type,
      args0.filter((one): one is Parameter => !!one.label),
    );
  }
}

/** The parameters of a skill's block; none of other blocks. */
export function parametersOf(type: string): readonly Parameter[] {
  return parameters.get(type) ?? [];
}

/** The limits and options of a field's parameter. */
export function allowedAt(field: Blockly.Field): Allowed {
  const place = field.getSourceBlock()?.outputConnection?.targetConnection;
  const name = place?.getParentInput()?.name ?? "";
  return known.get(`${place?.getSourceBlock().type} ${name}`) ?? FREE;
}
