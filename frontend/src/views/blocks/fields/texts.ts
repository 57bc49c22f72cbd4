/** Fields for texts: one of some choices, a colour. */

import * as Blockly from "blockly/core";

import { t } from "../../../i18n";
import { allowedAt } from "./allowed";
import { FreeChoice } from "./free-choice";
import { openPanel } from "./panel";

/** A choice among the parameter's options, known once the block is in the workspace. */
export class FieldChoice extends FreeChoice {
  constructor() {
    super(choices);
  }
}

function choices(this: Blockly.FieldDropdown): Blockly.MenuOption[] {
  const { options = [] } = allowedAt(this as Blockly.Field);
  const found = options.map(([label, value]): Blockly.MenuOption => [label, value]);
  const own = this.getValue() ?? "";
  return found.length && found.some((option) => option[1] === own) ? found : [[own, own], ...found];
}

/** The colours offered besides a free choice: easy to tell apart on an LED. */
const COLOURS = {
  red: "#ff0000",
  orange: "#ff8800",
  yellow: "#ffff00",
  green: "#00ff00",
  cyan: "#00ffff",
  blue: "#0000ff",
  purple: "#8800ff",
  pink: "#ff66aa",
  white: "#ffffff",
  black: "#000000",
} as const;
const HEXADECIMAL = /^#[0-9a-f]{6}$/i;

/** A colour as #rrggbb, shown in that colour. */
export class FieldColour extends Blockly.FieldTextInput {
  protected override showEditor_(): void {
    const before = this.getValue();
    openPanel(this as Blockly.Field, this.panel(), { undo: () => this.setValue(before) });
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

  private panel(): HTMLElement {
    const panel = document.createElement("div");
    const own = Object.assign(document.createElement("input"), {
      type: "color",
      ariaLabel: t("page-blocks-other-colour"),
    });
    own.value = colourOf(this.getValue()) ?? "#000000";
    own.title = own.ariaLabel;
    own.addEventListener("input", () => this.setValue(own.value));
    panel.append(...Object.entries(COLOURS).map(([name, colour]) => this.swatch(name, colour)), own);
    return panel;
  }

  private swatch(name: string, colour: string): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.ariaLabel = button.title = t(`page-blocks-colour-${name}`);
    button.style.background = colour;
    button.addEventListener("click", () => {
      this.setValue(colour);
      Blockly.DropDownDiv.hideIfOwner(this as Blockly.Field);
    });
    return button;
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
