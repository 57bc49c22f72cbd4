/** Blocks of types that the palette does not know, shown by name so that nothing is lost. */

import * as Blockly from "blockly/core";

import type { Block } from "../../protocol/messages";
import type { Node } from "./flat";

type Unknown = Blockly.Block & { kept?: unknown };

const unknownTypes = new Set<string>();

/** Defines the type of a block, and those of its shadows, if they are not defined. */
export function ensureDefined(flat: Block): void {
  if (!Blockly.Blocks[flat.type]) define(flat.type);
  for (const { shadow } of Object.values(flat.inputs ?? {})) if (shadow) ensureDefined(shadow);
}

/** Forget that a type is unknown. */
export function forgetUnknown(type: string): void {
  unknownTypes.delete(type);
}

function define(type: string): void {
  unknownTypes.add(type);
  Blockly.Blocks[type] = {
    init(this: Unknown) {
      this.setStyle("lb_python");
      this.appendDummyInput("TITLE").appendField(type);
      this.setOutput(true);
    },
    // Its meaning is unknown; it is returned unchanged.
    saveExtraState(this: Unknown) {
      return this.kept ?? null;
    },
    loadExtraState(this: Unknown, state: unknown) {
      this.kept = state;
    },
  };
}

/** Gives a block of an unknown type a shape that fits its contents and its position. */
export function shapeUnknown(block: Blockly.Block, { block: flat, statement }: Node): void {
  if (!unknownTypes.has(flat.type)) return;
  if (statement) makeStatement(block);
  addFields(block, flat);
  addInputs(block, flat);
}

function makeStatement(block: Blockly.Block): void {
  block.setOutput(false);
  block.setPreviousStatement(true);
  block.setNextStatement(true);
}

function addFields(block: Blockly.Block, flat: Block): void {
  for (const [name, value] of Object.entries(flat.fields ?? {})) {
    block.getInput("TITLE")?.appendField(new Blockly.FieldLabelSerializable(String(value)), name);
  }
}

function addInputs(block: Blockly.Block, flat: Block): void {
  for (const [name, input] of Object.entries(flat.inputs ?? {})) {
    if (input.stack?.length) block.appendStatementInput(name);
    else block.appendValueInput(name).appendField(name);
  }
}
