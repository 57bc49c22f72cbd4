/** A plus or minus button that changes a block's shape. */

import * as Blockly from "blockly/core";

type Sign = "+" | "−";

const BARS: Record<Sign, string> = { "+": "M8 3v10M3 8h10", "−": "M3 8h10" };
const SIZE = 20;

function picture(sign: Sign): string {
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16">` +
    `<circle cx="8" cy="8" r="7.5" fill="white" fill-opacity=".9"/>` +
    `<path d="${BARS[sign]}" stroke="#1a2138" stroke-width="2" stroke-linecap="round"/></svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}

/** A field that works as a button; `change` reshapes its block as one edit. */
export function stepButton(sign: Sign, label: string, change: () => void): Blockly.FieldImage {
  return new Blockly.FieldImage(picture(sign), SIZE, SIZE, label, (field) => {
    const block = field.getSourceBlock();
    if (block && !block.isInFlyout && block.isEditable()) changeShape(block, change);
  });
}

/** Change the shape of a block and fire the event. */
export function changeShape(block: Blockly.Block, change: () => void): void {
  const group = Blockly.Events.getGroup();
  if (!group) Blockly.Events.setGroup(true);
  const before = shape(block);
  change();
  const after = shape(block);
  if (before !== after) {
    Blockly.Events.fire(new Blockly.Events.BlockChange(block, "mutation", null, before, after));
  }
  Blockly.Events.setGroup(group);
}

function shape(block: Blockly.Block): string {
  return JSON.stringify(block.saveExtraState?.() ?? null);
}
