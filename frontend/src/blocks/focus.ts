/** The focus stays with the block that has it. */

import * as Blockly from "blockly/core";

/**
 * Gives the focus back when Blockly has taken it away unawares.
 *
 * In the frame after a connection was lit up Blockly puts its light behind all that hangs beside it. A
 * block that was put there meanwhile is moved in the page's tree, loses the focus, and with it the keyboard
 * is lost: so it went for whoever pressed Enter twice within a frame.
 */
export function keepFocus(): void {
  const { highlight } = Blockly.RenderedConnection.prototype;
  Blockly.RenderedConnection.prototype.highlight = function (this: Blockly.RenderedConnection) {
    let focused: Element | null = null;
    requestAnimationFrame(() => (focused = document.activeElement));
    highlight.call(this);
    requestAnimationFrame(() => focusAgain(focused));
  };
}

function focusAgain(element: Element | null): void {
  const lost = element !== document.activeElement && element?.isConnected;
  if (lost) (element as HTMLElement | SVGElement).focus({ preventScroll: true });
}

/** Have a block take the focus from an icon of its own that is about to go, or from the icon's bubble. */
export function takeFromIcon(block: Blockly.BlockSvg, type: Blockly.icons.IconType<Blockly.IIcon>): void {
  const icon = block.getIcon(type);
  const focused = Blockly.getFocusManager().getFocusedNode();
  if (!icon || !focused) return;
  const bubble = Blockly.hasBubble(icon) ? icon.getBubble() : null;
  if (focused === icon || focused === bubble) Blockly.getFocusManager().focusNode(block);
}
