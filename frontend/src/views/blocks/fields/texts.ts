/** Fields for texts: one of some choices, a colour. */

import * as Blockly from "blockly/core";

import { t } from "../../../i18n";
import { allowedAt } from "./allowed";
import { colourPanel } from "./colour-panel";
import { FreeChoice } from "./free-choice";
import { openPanel } from "./panel";
import { areNotes, piano } from "./piano";

/** The menu entry that asks for another text. */
const OTHER = "\u0000other";

/** A choice among the parameter's options, known once the block is in the workspace. */
export class FieldChoice extends FreeChoice {
  constructor() {
    super(choices);
  }

  /** Notes are chosen on a piano. */
  protected override showEditor_(event?: MouseEvent): void {
    const { options = [] } = allowedAt(this as Blockly.Field);
    if (!areNotes(options.map(([, value]) => value))) return super.showEditor_(event);
    const before = this.getValue();
    const close = () => Blockly.DropDownDiv.hideIfOwner(this as Blockly.Field);
    const keys = piano(options, String(before), (note) => this.setValue(note), close);
    openPanel(this as Blockly.Field, keys, { undo: () => this.setValue(before) });
    keys.querySelector<HTMLElement>("[aria-checked=true]")?.focus({ preventScroll: true });
  }

  protected override doClassValidation_(value?: string): string | null {
    if (value === OTHER) this.askForOther();
    return value === OTHER ? null : super.doClassValidation_(value);
  }

  private askForOther(): void {
    Blockly.dialog.prompt(t("page-blocks-other-prompt"), this.getValue() ?? "", (answer) => {
      if (answer?.trim()) this.setValue(answer.trim());
    });
  }
}

function choices(this: Blockly.FieldDropdown): Blockly.MenuOption[] {
  const { options = [], open = false } = allowedAt(this as Blockly.Field);
  const usual = options.map(([label, value]): Blockly.MenuOption => [label, value]);
  const found = open ? [...usual, [t("page-blocks-other"), OTHER] as Blockly.MenuOption] : usual;
  const own = this.getValue() ?? "";
  return usual.some((option) => option[1] === own) ? found : [[own, own], ...found];
}

const HEXADECIMAL = /^#[0-9a-f]{6}$/i;

/** A colour as #rrggbb, shown in that colour. */
export class FieldColour extends Blockly.FieldTextInput {
  protected override showEditor_(): void {
    const before = this.getValue();
    const field = this as Blockly.Field;
    const panel = colourPanel(field, colourOf(before) ?? "#000000", (colour) => this.setValue(colour));
    openPanel(field, panel, { undo: () => this.setValue(before) });
  }

  protected override render_(): void {
    super.render_();
    const colour = colourOf(this.getValue());
    const block = this.getSourceBlock();
    if (!colour || !(block instanceof Blockly.BlockSvg)) return;
    const text = isLight(colour) ? "#000000" : "#ffffff";
    block.pathObject.svgPath.setAttribute("fill", colour);
    this.textElement_?.style.setProperty("fill", text, "important");
  }

  override applyColour(): void {
    super.applyColour();
    this.forceRerender();
  }

  override getAriaTypeName(): string {
    return t("page-blocks-colour");
  }
}

function colourOf(value: string | null): string | null {
  return value !== null && HEXADECIMAL.test(value) ? value : null;
}

/** Whether black is more legible on it than white, by its luminance. */
function isLight(colour: string): boolean {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
  return 0.299 * red + 0.587 * green + 0.114 * blue > 140;
}
