/** A box to tick: yes or no. */

import * as Blockly from "blockly/core";

/** Beside the mark, so that the box is as wide as it is high; in units of the workspace. */
const MARGIN = 10;

export class FieldTick extends Blockly.FieldCheckbox {
  /** As in Blockly's block for yes and no. */
  override saveState(): string {
    return this.getValue();
  }

  protected override updateSize_(): void {
    super.updateSize_(MARGIN);
  }
}
