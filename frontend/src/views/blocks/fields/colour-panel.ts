/** The panel in which a colour is chosen: some that are easy to tell apart, and any other. */

import * as Blockly from "blockly/core";

import { t } from "../../../i18n";

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

type Take = (colour: string) => void;

/** @param take receives the colour as #rrggbb, also while another one is being mixed. */
export function colourPanel(field: Blockly.Field, value: string, take: Take): HTMLElement {
  const panel = document.createElement("div");
  const choose = (colour: string) => {
    take(colour);
    Blockly.DropDownDiv.hideIfOwner(field);
  };
  panel.append(...Object.entries(COLOURS).map(([name, colour]) => swatch(name, colour, choose)), mixer(value, take));
  return panel;
}

function swatch(name: string, colour: string, choose: Take): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.ariaLabel = button.title = t(`page-blocks-colour-${name}`);
  button.style.background = colour;
  button.addEventListener("click", () => choose(colour));
  return button;
}

function mixer(value: string, take: Take): HTMLInputElement {
  const own = Object.assign(document.createElement("input"), {
    type: "color",
    ariaLabel: t("page-blocks-other-colour"),
  });
  own.value = value;
  own.title = own.ariaLabel;
  own.addEventListener("input", () => take(own.value));
  return own;
}
