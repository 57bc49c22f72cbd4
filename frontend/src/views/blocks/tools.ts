/** The buttons for the zoom and the bin, drawn like the buttons of the page. */

import * as Blockly from "blockly/core";

import { type IconName, icon } from "../../ui/icons";

const { Svg, dom } = Blockly.utils;
const ICON = 20;
/** Between two buttons, and from the bin to the edge. */
const GAP = 8;
const EDGE = 20;
/** Blockly reserves this place for the bin, at the bottom of which its button is. */
const BIN = { width: 47, height: 60 };

/** Private members of Blockly's zoom controls: their measures, used before they are placed. */
interface Measures {
  WIDTH: number;
  HEIGHT: number;
  SMALL_SPACING: number;
  LARGE_SPACING: number;
  MARGIN_HORIZONTAL: number;
}

const ZOOM: Readonly<Record<string, IconName>> = {
  blocklyZoomIn: "plus",
  blocklyZoomOut: "minus",
  blocklyZoomReset: "follow",
};

/** Draw the buttons of a workspace above each other at the edge, where few blocks reach; fingers get larger ones. */
export function drawTools(workspace: Blockly.WorkspaceSvg): void {
  const size = matchMedia("(pointer: coarse)").matches ? 44 : 40;
  const measures = workspace.zoomControls_ as unknown as Measures | null;
  if (measures) Object.assign(measures, inColumn(size));
  const svg = workspace.getParentSvg();
  for (const [kind, name] of Object.entries(ZOOM)) draw(svg.querySelector(`.${kind}`), name, { size });
  const bin = svg.querySelector(".blocklyTrash");
  draw(bin, "trash", { size, left: BIN.width - size, top: BIN.height - size });
  workspace.resize();
}

function inColumn(size: number): Measures {
  return { WIDTH: size, HEIGHT: size, SMALL_SPACING: GAP, LARGE_SPACING: GAP, MARGIN_HORIZONTAL: EDGE };
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
  // The label of the bin says whether it is empty, so it changes.
  if (name !== "trash") addTitle(button);
}

function addTitle(button: Element): void {
  const title = document.createElementNS(dom.SVG_NS, "title");
  title.textContent = button.getAttribute("aria-label");
  button.append(title);
}
