/** Replaces a statement by one of another type with the same inputs, which keeps everything else. */

import * as Blockly from "blockly/core";

const OWN = { addCoordinates: true, addNextBlocks: false, doFullSerialization: true };

/** The new block has the id, the values, the comment and the place of the old one, and the focus if that had it. */
export function become(block: Blockly.BlockSvg, type: string): void {
  const { workspace } = block;
  const state = Blockly.serialization.blocks.save(block, OWN);
  if (!state) return;
  const above = block.previousConnection?.targetConnection;
  const below = block.nextConnection?.targetConnection;
  const isFocused = Blockly.getFocusManager().getFocusedNode() === block || isInside(block);
  block.unplug(true);
  block.dispose(false);
  const created = Blockly.serialization.blocks.append({ ...state, type }, workspace, { recordUndo: true });
  const fresh = created as Blockly.BlockSvg;
  if (above) above.connect(fresh.previousConnection!);
  else if (below) fresh.nextConnection!.connect(below);
  if (isFocused) Blockly.getFocusManager().focusNode(fresh);
}

/** Whether the focus is on a part of the block, such as its menu. */
function isInside(block: Blockly.BlockSvg): boolean {
  const focused = Blockly.getFocusManager().getFocusedNode();
  return focused instanceof Blockly.Field && focused.getSourceBlock() === block;
}
