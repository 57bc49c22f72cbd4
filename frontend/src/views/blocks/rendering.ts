/** Blockly's rendering without the parts that are slow for large programs. */

import * as Blockly from "blockly/core";

const block = Blockly.BlockSvg.prototype;

/** Call it once, before the first workspace is created. */
export function tuneRendering(): void {
  hideRuler();
  enlargeButtons();
  forgetDisposed();
  bumpOnlyWhatIsDropped();
}

// Blockly measures texts with a canvas outside of any region, where a screen reader would find it.
function hideRuler(): void {
  const text = Blockly.utils.dom.createSvgElement(Blockly.utils.Svg.TEXT, {}) as SVGTextElement;
  Blockly.utils.dom.getFastTextWidthWithSizeString(text, "11pt", "600", "sans-serif");
  document.querySelector(".blocklyComputeCanvas")?.setAttribute("aria-hidden", "true");
}

// A button of the palette, such as "New event…", is as large a target as the page's own buttons.
function enlargeButtons(): void {
  const isFinger = matchMedia("(pointer: coarse)").matches;
  Blockly.FlyoutButton.TEXT_MARGIN_X = 16;
  Blockly.FlyoutButton.TEXT_MARGIN_Y = isFinger ? 20 : 17;
}

// Blockly removes only drawn blocks from its queue, and disposed blocks are never drawn: without this
// every removed block stays in memory and is visited at each rendering.
function forgetDisposed(): void {
  const { queueRender } = block;
  block.queueRender = function (this: Blockly.BlockSvg) {
    return this.isDeadOrDying() ? Promise.resolve() : queueRender.call(this);
  };
}

// After each rendering it compares every block with its neighbours, up to the top of both stacks:
// 0.3 s with 5,000 blocks. `places.ts` places stacks instead; a block that was
// dropped beside one that it does not fit is still moved away.
function bumpOnlyWhatIsDropped(): void {
  const { bumpNeighbours } = block;
  block.bumpNeighbours = () => {};
  block.scheduleSnapAndBump = function (this: Blockly.BlockSvg) {
    this.snapToGrid();
    bumpNeighbours.call(this);
  };
}
