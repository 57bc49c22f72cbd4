/** Makes the palette's blocks options of a list for screen readers, without inner elements. */

import * as Blockly from "blockly/core";

const { BlockFlyoutInflater, registry } = Blockly;

/** Private members of a Blockly connection: its highlight element has a role. */
interface Lit {
  getSourceBlock(): Blockly.BlockSvg;
  setAriaRole(element: Element): void;
}

/**
 * Blockly gives each connection of a palette block a role that is invalid in a list, and makes the
 * block own elements that may not exist. They cannot be reached before the block is in the program.
 */
export function offerPlainly(): void {
  registry.register(registry.Type.FLYOUT_INFLATER, "block", PlainInflater, true);
  const connection = Blockly.RenderedConnection.prototype as unknown as Lit;
  const { setAriaRole } = connection;
  connection.setAriaRole = function (this: Lit, element) {
    if (this.getSourceBlock().isInFlyout) element.removeAttribute("role");
    else setAriaRole.call(this, element);
  };
}

class PlainInflater extends BlockFlyoutInflater {
  override load(state: object, flyout: Blockly.IFlyout): Blockly.FlyoutItem {
    const item = super.load(state, flyout);
    const block = item.getElement() as Blockly.BlockSvg;
    disown(block);
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
