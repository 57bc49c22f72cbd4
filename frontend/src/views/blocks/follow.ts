/** Where the program scrolls to while it runs. */

import * as Blockly from "blockly/core";

interface View {
  readonly left: number;
  readonly width: number;
}

/**
 * The area to bring into sight for a block that runs: a program that fits must not move sideways, so a block that can
 * be seen only asks for its height.
 */
export function areaToFollow(block: Blockly.utils.Rect, { left, width }: View): Blockly.utils.Rect {
  const isBeside = block.right <= left || block.left >= left + width;
  if (isBeside) return block;
  const middle = left + width / 2;
  return new Blockly.utils.Rect(block.top, block.bottom, middle, middle);
}
