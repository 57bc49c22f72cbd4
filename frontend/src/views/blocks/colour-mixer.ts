/** A swatch on blocks that take red, green and blue: it shows their colour and chooses all three at once. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { colourOf, partsOf } from "./colours";
import { colourPanel } from "./fields/colour-panel";
import { openPanel } from "./fields/panel";
import { beforeDrawing } from "./patches";

const NAME = "LB_COLOUR";
const PARTS = ["red", "green", "blue"] as const;
const SIZE = { width: 34, height: 26 };

class ColourMixer extends Blockly.FieldImage {
  override readonly SERIALIZABLE = false;

  constructor() {
    super(picture(null), SIZE.width, SIZE.height, "", (field) => (field as ColourMixer).open());
  }

  /** Its name as a button; the numbers beside it are the sentence. */
  override getAriaValue(): string {
    return t("page-blocks-colour");
  }

  /** A block is measured whenever a value in it has changed, also by another view. */
  override getSize(): Blockly.utils.Size {
    const now = picture(this.colour);
    if (now !== this.getValue()) this.setValue(now, false);
    return super.getSize();
  }

  private open(): void {
    const block = this.getSourceBlock();
    const before = this.colour;
    if (!before || !block?.isEditable() || block.isInFlyout) return;
    const field = this as Blockly.Field;
    openPanel(
      field,
      colourPanel(field, before, (colour) => this.take(colour)),
      { undo: () => this.take(before) },
    );
  }

  private get colour(): string | null {
    return colourOf(PARTS.map((part) => this.number(part)?.getValue() ?? null));
  }

  /** The number in a place; null if something else is there, such as a variable. */
  private number(part: string): Blockly.Field<number> | null {
    return this.getSourceBlock()?.getInputTargetBlock(part)?.getField("NUM") ?? null;
  }

  private take(colour: string): void {
    const group = Blockly.Events.getGroup();
    if (!group) Blockly.Events.setGroup(true);
    partsOf(colour).forEach((value, index) => this.number(PARTS[index] ?? "")?.setValue(value));
    Blockly.Events.setGroup(group);
  }
}

/** A swatch in a colour; a question mark without one. */
function picture(colour: string | null): string {
  const { width, height } = SIZE;
  const mark = colour ? "" : `<text x="17" y="19" font-size="17" text-anchor="middle" fill="#1a2138">?</text>`;
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">` +
    `<rect x="1.500" y="1.500" width="31" height="23" rx="11.500" fill="${colour ?? "#ffffff"}" ` +
    `stroke="#ffffff" stroke-width="3"/>${mark}</svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}

/** Call it once, before the first block is created. */
export function mixColours(): void {
  beforeDrawing(addMixer);
}

function addMixer(block: Blockly.BlockSvg): void {
  if (block.getField(NAME) || !PARTS.every((part) => block.getInput(part))) return;
  block.getInput(PARTS[0])?.insertFieldAt(0, new ColourMixer(), NAME);
}
