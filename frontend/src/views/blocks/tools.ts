/** The bin, drawn like the buttons of the page; those of the zoom are in the head of the views, where no block is. */

import * as Blockly from "blockly/core";

import { type IconName, icon } from "../../ui/icons";

const { Svg, dom } = Blockly.utils;
const ICON = 20;
/** Blockly reserves this place for the bin, at the bottom of which its button is. */
const BIN = { width: 47, height: 60 };

/** Draw the bin of a workspace at the edge, where few blocks reach; fingers get a larger one. */
export function drawBin(workspace: Blockly.WorkspaceSvg): void {
  const size = matchMedia("(pointer: coarse)").matches ? 44 : 40;
  const bin = workspace.getParentSvg().querySelector(".blocklyTrash");
  draw(bin, "trash", { size, left: BIN.width - size, top: BIN.height - size });
  workspace.resize();
}

interface Place {
  readonly size: number;
  /** Its distance from the corner of its place. */
  readonly left?: number;
  readonly top?: number;
}

/** Draw a button in place of Blockly's pictures; its role, label and keys are Blockly's. */
function draw(button: Element | null, name: IconName, { size, left = 0, top = 0 }: Place): void {
  if (!button) return;
  button.replaceChildren();
  button.classList.add("lbTool");
  dom.createSvgElement(Svg.RECT, { x: left, y: top, width: size, height: size, rx: 12, class: "lbToolFace" }, button);
  const picture = icon(name);
  const place = { x: left + (size - ICON) / 2, y: top + (size - ICON) / 2, width: ICON, height: ICON };
  for (const [key, value] of Object.entries(place)) picture.setAttribute(key, String(value));
  button.append(picture);
}
