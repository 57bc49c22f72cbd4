/** Values of variables beside the blocks, at the moment that is shown. */

import type * as Blockly from "blockly/core";

type Svg = Blockly.BlockSvg;

const SVG = "http://www.w3.org/2000/svg";
/** Space between a block and its label, and inside the label, in the workspace's units. */
const GAP = 10;
const PADDING = 8;
const HEIGHT = 24;
/** The top of a block's first row. */
const TOP = 8;

/** Labels that move with their blocks; set them again after blocks have been replaced. */
export class ValueLabels {
  private labels: SVGElement[] = [];

  constructor(private readonly find: (id: string) => Svg | null) {}

  /** Show texts beside blocks, by their ids, and no others. */
  show(texts: ReadonlyMap<string, string>): void {
    for (const label of this.labels) label.remove();
    this.labels = [];
    for (const [id, text] of texts) {
      const block = this.find(id);
      if (block) this.labels.push(draw(block, text));
    }
  }
}

function draw(block: Svg, text: string): SVGElement {
  const label = create("g", { class: "lbValues" });
  const words = create("text", { x: PADDING, y: HEIGHT / 2 });
  words.textContent = text;
  const plate = create("rect", { height: HEIGHT, rx: HEIGHT / 2 });
  label.append(plate, words);
  block.getSvgRoot().append(label);
  // What is nested below makes a block wider than its own first row.
  const { x, width } = (block.pathObject.svgPath as SVGGraphicsElement).getBBox();
  label.setAttribute("transform", `translate(${x + width + GAP} ${TOP})`);
  plate.setAttribute("width", `${words.getComputedTextLength() + 2 * PADDING}`);
  return label;
}

function create<Name extends "g" | "rect" | "text">(name: Name, attributes: Record<string, string | number>) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, `${value}`);
  return made;
}
