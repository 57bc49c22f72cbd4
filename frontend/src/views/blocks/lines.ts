/** The lines of a sentence in the palette, close to each other. */

import * as Blockly from "blockly/core";

import { LINE } from "./line-labels";

/** The room between two lines in units of the workspace. */
const GAP = 2;

class LineInflater extends Blockly.LabelFlyoutInflater {
  override gapForItem(): number {
    return GAP;
  }

  override getType(): string {
    return LINE;
  }
}

/** Call it once, before the first workspace is created. */
export function registerLines(): void {
  Blockly.registry.register(Blockly.registry.Type.FLYOUT_INFLATER, LINE, LineInflater, true);
}
