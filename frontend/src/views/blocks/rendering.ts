/** Blockly's rendering without the parts that are slow for large programs, and with larger buttons. */

import * as Blockly from "blockly/core";

import { bumpOnlyWhatIsDropped, forgetDisposed, hideRuler, removeOutlineLabels } from "./patches";

/** Call it once, before the first workspace is created. */
export function tuneRendering(): void {
  hideRuler();
  removeOutlineLabels();
  enlargeButtons();
  forgetDisposed();
  bumpOnlyWhatIsDropped();
}

// A button of the palette, such as "New event…", is as large a target as the page's own buttons.
function enlargeButtons(): void {
  const isFinger = matchMedia("(pointer: coarse)").matches;
  Blockly.FlyoutButton.TEXT_MARGIN_X = 16;
  Blockly.FlyoutButton.TEXT_MARGIN_Y = isFinger ? 20 : 17;
}
