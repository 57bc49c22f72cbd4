/** Moves keyboard focus away from what is about to disappear. */

import * as Blockly from "blockly/core";

/** Move the focus to a block from an icon of it that is about to disappear, or from the icon's bubble. */
export function takeFromIcon(block: Blockly.BlockSvg, type: Blockly.icons.IconType<Blockly.IIcon>): void {
  const icon = block.getIcon(type);
  const focused = Blockly.getFocusManager().getFocusedNode();
  if (!icon || !focused) return;
  const bubble = Blockly.hasBubble(icon) ? icon.getBubble() : null;
  if (focused === icon || focused === bubble) Blockly.getFocusManager().focusNode(block);
}
