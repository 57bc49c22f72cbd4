/** Reads Blockly's workspace as ours, whose stacks are lists of blocks. */

import * as Blockly from "blockly/core";

import type { Block, BlockComment, Input, Workspace } from "../../protocol/messages";

import { inDrawnOrder } from "./places";

type State = Blockly.serialization.blocks.State;

const OWN_ONLY = { addInputBlocks: false, addNextBlocks: false, doFullSerialization: false };

/** The whole workspace. */
export function readWorkspace(workspace: Blockly.WorkspaceSvg): Workspace {
  // The order of the program is the one that is drawn, not that in which the stacks were made.
  const tops = inDrawnOrder(workspace.getTopBlocks(false).filter((block) => !block.isInsertionMarker()));
  return {
    stacks: tops.map(readStack),
    variables: workspace
      .getVariableMap()
      .getAllVariables()
      .map((variable) => ({ name: variable.getName(), id: variable.getId() })),
  };
}

function readStack(top: Blockly.BlockSvg): Block[] {
  const chain = readChain(top);
  const place = top.getRelativeToSurfaceXY();
  Object.assign(chain[0]!, { x: Math.round(place.x), y: Math.round(place.y) });
  return chain;
}

// A loop instead of Blockly's recursion, which overflows the call stack with some thousand blocks.
function readChain(first: Blockly.Block): Block[] {
  const chain: Block[] = [];
  for (let block: Blockly.Block | null = first; block; block = block.getNextBlock()) {
    if (!block.isInsertionMarker()) chain.push(readBlock(block));
  }
  return chain;
}

function readBlock(block: Blockly.Block): Block {
  const flat = readOwn(block);
  const inputs = readInputs(block);
  if (inputs) flat.inputs = inputs;
  return flat;
}

/** A block without its children. */
export function readOwn(block: Blockly.Block): Block {
  const state = Blockly.serialization.blocks.save(block, OWN_ONLY);
  if (!state) throw new Error(`a block of type ${block.type} is only a mark of a drag`);
  const flat = fromState(state);
  if (!flat.comment && hasEmptyComment(block)) flat.comment = { text: "" };
  return flat;
}

// Blockly drops a comment without text; a `#` that came from the text has notes in the block's data,
// and a comment that the user has just opened has none yet.
function hasEmptyComment(block: Blockly.Block): boolean {
  return block.data !== null && block.getCommentText() === "";
}

function readInputs(block: Blockly.Block): Record<string, Input> | null {
  const inputs: Record<string, Input> = {};
  for (const { connection, name, type } of block.inputList) {
    if (!connection) continue;
    const input = readConnection(connection, type === Blockly.inputs.inputTypes.STATEMENT);
    if (input) inputs[name] = input;
  }
  return Object.keys(inputs).length ? inputs : null;
}

function readConnection(connection: Blockly.Connection, statements: boolean): Input | null {
  const input: Input = {};
  const shadow = connection.getShadowState(true);
  if (shadow) input.shadow = fromState(shadow);
  const target = connection.targetBlock();
  if (target && !target.isShadow() && !target.isInsertionMarker()) {
    if (statements) input.stack = readChain(target);
    else input.block = readBlock(target);
  }
  return input.shadow || input.block || input.stack ? input : null;
}

/** A flat block from Blockly's state; only shadows are plugged in. */
function fromState(state: State): Block {
  const { type, id, fields, extraState, data, collapsed, disabledReasons, inline, icons, inputs } = state;
  const flat: Block = { type, id: id ?? "" };
  if (fields) flat.fields = fields;
  if (extraState !== undefined) flat.extraState = extraState;
  if (data !== undefined) flat.data = data;
  if (collapsed) flat.collapsed = true;
  if (disabledReasons?.length) flat.disabledReasons = disabledReasons;
  if (inline !== undefined) flat.inline = inline;
  if (icons?.comment) flat.comment = fromComment(icons.comment);
  if (inputs) flat.inputs = fromInputs(inputs);
  return flat;
}

function fromComment(icon: { text?: string; pinned?: boolean; width?: number; height?: number }): BlockComment {
  const { text = "", pinned, width, height } = icon;
  return {
    text,
    ...(pinned ? { pinned } : {}),
    ...(width === undefined ? {} : { width }),
    ...(height === undefined ? {} : { height }),
  };
}

function fromInputs(inputs: NonNullable<State["inputs"]>): Record<string, Input> {
  const found: Record<string, Input> = {};
  for (const [name, { shadow, block }] of Object.entries(inputs)) {
    found[name] = {
      ...(shadow ? { shadow: fromState(shadow) } : {}),
      ...(block ? { block: fromState(block) } : {}),
    };
  }
  return found;
}

/** A shadow's state, in Blockly's format. */
export function toState(flat: Block): State {
  const { type, id, fields, extraState, data, inputs } = flat;
  return {
    type,
    id,
    ...(fields ? { fields } : {}),
    ...(extraState == null ? {} : { extraState }),
    ...(data == null ? {} : { data }),
    ...(inputs ? { inputs: toInputs(inputs) } : {}),
  };
}

function toInputs(inputs: Record<string, Input>): NonNullable<State["inputs"]> {
  const written: NonNullable<State["inputs"]> = {};
  for (const [name, { shadow, block }] of Object.entries(inputs)) {
    written[name] = {
      ...(shadow ? { shadow: toState(shadow) } : {}),
      ...(block ? { block: toState(block) } : {}),
    };
  }
  return written;
}
