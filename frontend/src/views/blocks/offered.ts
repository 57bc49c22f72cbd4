/** Makes the palette's blocks options of a list for screen readers, without inner elements. */

import * as Blockly from "blockly/core";

import { PaletteFlyout } from "./palette-flyout";
import { leaveOutRoles } from "./patches";
import { splitWords } from "./wrapping";

const { BlockFlyoutInflater, registry } = Blockly;

/**
 * Blockly gives each connection of a palette block a role that is invalid in a list, and makes the
 * block own elements that may not exist. They cannot be reached before the block is in the program.
 */
export function offerPlainly(): void {
  registry.register(registry.Type.FLYOUT_INFLATER, "block", PlainInflater, true);
  leaveOutRoles();
}

class PlainInflater extends BlockFlyoutInflater {
  override load(state: object, flyout: Blockly.IFlyout): Blockly.FlyoutItem {
    const item = super.load(state, flyout);
    const block = item.getElement() as Blockly.BlockSvg;
    disown(block);
    if (flyout instanceof PaletteFlyout) splitWords(block, flyout.room);
    // The reason is in the heading above it.
    if ((state as { lacking?: boolean }).lacking) block.addClass("lbLacking");
    return item;
  }
}

function disown(block: Blockly.BlockSvg): void {
  const option = block.getFocusableElement();
  const places = block.getConnections_(true).map((connection) => connection.id);
  const owned = option.getAttribute("aria-owns")?.split(" ") ?? [];
  option.setAttribute("aria-owns", owned.filter((id) => !places.includes(id)).join(" "));
}
