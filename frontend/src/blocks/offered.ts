/** The blocks that the palette offers, to a screen reader: options of a list, and nothing within them. */

import * as Blockly from "blockly/core";

const { BlockFlyoutInflater, registry } = Blockly;

/** What Blockly keeps to itself of a connection: the element that lights it up is given a role. */
interface Lit {
  getSourceBlock(): Blockly.BlockSvg;
  setAriaRole(element: Element): void;
}

/**
 * Blockly gives each place of an offered block a role that has no business in a list, and makes the
 * block own places that may not be there. Nobody can go to them before the block is in the program.
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
    disown(item.getElement() as Blockly.BlockSvg);
    return item;
  }
}

function disown(block: Blockly.BlockSvg): void {
  const option = block.getFocusableElement();
  const places = block.getConnections_(true).map((connection) => connection.id);
  const owned = option.getAttribute("aria-owns")?.split(" ") ?? [];
  option.setAttribute("aria-owns", owned.filter((id) => !places.includes(id)).join(" "));
}
