/** Keeps keyboard focus on the current block. */

import * as Blockly from "blockly/core";

/**
 * Returns the focus when Blockly has removed it by accident.
 *
 * In the frame after it highlights a connection, Blockly moves the highlight behind the blocks next to it. A
 * block that was inserted meanwhile is moved in the DOM and loses the focus, and the keyboard
 * stops working: this happened when Enter was pressed twice within a frame.
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

/** Move the focus to a block from an icon of it that is about to disappear, or from the icon's bubble. */
export function takeFromIcon(block: Blockly.BlockSvg, type: Blockly.icons.IconType<Blockly.IIcon>): void {
  const icon = block.getIcon(type);
  const focused = Blockly.getFocusManager().getFocusedNode();
  if (!icon || !focused) return;
  const bubble = Blockly.hasBubble(icon) ? icon.getBubble() : null;
  if (focused === icon || focused === bubble) Blockly.getFocusManager().focusNode(block);
}
