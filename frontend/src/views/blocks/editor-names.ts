/** Names for what a field opens, a menu or an input: Blockly gives them none. */

import * as Blockly from "blockly/core";

import { afterEditorOpens } from "./patches";

const { DropDownDiv, WidgetDiv } = Blockly;

/** Call it once, before the first field is opened. */
export function nameEditors(): void {
  afterEditorOpens((field) => {
    const menu = DropDownDiv.getContentDiv().querySelector("[role=listbox]");
    const input = WidgetDiv.getDiv()?.querySelector(".blocklyHtmlInput");
    for (const opened of [menu, input]) opened?.setAttribute("aria-label", nameOf(field));
  });
}

/** What kind of value it is, and the sentence of the block that it is a part of. */
function nameOf(field: Blockly.Field): string {
  const block = field.getSourceBlock() as Blockly.BlockSvg;
  const whole = (block.isShadow() && block.getParent()) || block;
  const sentence = whole.getAriaLabel(Blockly.utils.aria.Verbosity.TERSE);
  return [field.getAriaTypeName(), sentence].filter(Boolean).join(": ");
}
