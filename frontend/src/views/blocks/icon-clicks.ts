/** Lets a click on an icon open it, also on blocks that consist of one field, such as variables. */

import * as Blockly from "blockly/core";

/** Private members of a Blockly gesture. */
interface Started {
  startIcon: Blockly.IIcon | null;
  setStartField(field: Blockly.Field): void;
}

/** In Blockly the field of such a block takes every click, so its warning could not be read. */
export function preferIcons(): void {
  const gesture = Blockly.Gesture.prototype as unknown as Started;
  const { setStartField } = gesture;
  gesture.setStartField = function (this: Started, field) {
    // The icon is inside the block, so it has received the click first.
    if (!this.startIcon) setStartField.call(this, field);
  };
}
