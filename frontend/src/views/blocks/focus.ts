/** Keeps keyboard focus on the current block. */

import * as Blockly from "blockly/core";

/**
 * Returns the focus when Blockly has removed it by accident.
 *
 * Blockly brings a focused block, or a highlighted connection, to the front only in the next frame, by moving
 * everything beside it behind it. What has received the focus meanwhile is then moved in the DOM and loses it, and the
 * keyboard stops working: this happened when two keys were pressed within a frame.
 */
export function keepFocus(): void {
  keepFocusAfter(Blockly.RenderedConnection.prototype, "highlight");
  // TypeScript does not know this method, which is internal to Blockly.
  keepFocusAfter(Blockly.BlockSvg.prototype as unknown as { moveSvgRootToFront: Act }, "moveSvgRootToFront");
}

type Act = (...args: unknown[]) => void;

/** Return the focus after the next frame's part of a method. */
function keepFocusAfter<Name extends string>(prototype: Record<Name, Act>, name: Name): void {
  const method = prototype[name];
  prototype[name] = function (this: unknown, ...args) {
    let focused: Element | null = null;
    requestAnimationFrame(() => (focused = document.activeElement));
    method.apply(this, args);
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
