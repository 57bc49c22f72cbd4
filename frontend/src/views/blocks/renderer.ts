/** Blockly's rendering with a word in each empty place, such as "number". */

import * as Blockly from "blockly/core";

import { arrangeOptional } from "./optional";
import { PaletteFlyout } from "./palette-flyout";
import { linesOf } from "./wrapping";

type Block = Blockly.BlockSvg;
type Measurable = Blockly.blockRendering.Measurable;
type Place = Blockly.blockRendering.InlineInput;

const NAME = "zelos";
/** In units of the workspace. */
const FONT_SIZE = 16;
/** Between the last word of a statement and its edge, beyond Blockly's padding. */
const LAST_WORD = 6;
/** The part of a word that an empty place without a word has room for. */
const ROOM = 14;

/** The messages for what a place expects, by its check; a place for anything has no word. */
const WORDS: Readonly<Record<string, string>> = {
  Boolean: "LB_SLOT_QUESTION",
  Number: "LB_SLOT_NUMBER",
  String: "LB_SLOT_TEXT",
  Array: "LB_SLOT_LIST",
};

/** What belongs into a place, such as "number"; empty if anything fits. */
export function wordOf(input: Blockly.Input): string {
  const checks = input.connection?.getCheck() ?? [];
  const word = checks.length === 1 ? WORDS[checks[0]!] : undefined;
  return (word && Blockly.Msg[word]) ?? "";
}

const measured = document.createElementNS("http://www.w3.org/2000/svg", "text");

// Blockly remembers the width of each word.
function widthOf(word: string): number {
  measured.textContent = word;
  const { getFastTextWidthWithSizeString } = Blockly.utils.dom;
  return getFastTextWidthWithSizeString(measured, `${FONT_SIZE}px`, "600", "Nunito Variable, sans-serif");
}

export class Info extends Blockly.zelos.RenderInfo {
  /** @param room the width in which the sentence is broken into lines, which Blockly only has for inputs; null for one line */
  constructor(
    renderer: Blockly.zelos.Renderer,
    block: Block,
    private readonly room: number | null,
  ) {
    super(renderer, block);
  }

  protected override createRows_(): void {
    super.createRows_();
    const { room, block_: block, constants_: constants } = this;
    if (room === null) return;
    const { InputRow } = Blockly.blockRendering;
    this.rows = this.rows.flatMap((row) => (row instanceof InputRow ? linesOf(row, block, room, constants) : [row]));
    this.inputRows = this.rows.filter((row) => row instanceof InputRow);
  }

  override addInput_(input: Blockly.Input, row: Blockly.blockRendering.Row): void {
    super.addInput_(input, row);
    const place = row.elements.at(-1);
    if (place instanceof Blockly.blockRendering.InlineInput && isEmpty(place)) {
      place.width += Math.max(0, widthOf(wordOf(input)) - ROOM);
    }
  }

  /** A sentence keeps away from the edge of its statement. */
  override getInRowSpacing_(before: Measurable | null, after: Measurable | null): number {
    const usual = super.getInRowSpacing_(before, after);
    const isLastWord = !after && before instanceof Blockly.blockRendering.Field && !this.outputConnection;
    return isLastWord ? usual + LAST_WORD : usual;
  }
}

/** Around a value in a block, such as "cuando" before it. */
const AROUND = 110;

/** The width that a block of the palette may have, in units of the workspace; null for those of the program. */
function roomBeside(block: Block): number | null {
  const flyout = block.isInFlyout ? block.workspace.targetWorkspace?.getFlyout() : null;
  if (!(flyout instanceof PaletteFlyout)) return null;
  return block.getParent() ? flyout.room - AROUND : flyout.room;
}

function isEmpty(place: Place): boolean {
  return !place.connectedBlock;
}

/** The words shown on each block, by the name of the input. */
const shown = new WeakMap<Block, Map<string, SVGTextElement>>();

class Drawer extends Blockly.zelos.Drawer {
  private readonly used = new Set<string>();

  override draw(): void {
    super.draw();
    for (const [name, word] of shown.get(this.block_) ?? []) {
      if (this.used.has(name)) continue;
      word.remove();
      shown.get(this.block_)?.delete(name);
    }
  }

  override drawInlineInput_(place: Place): void {
    super.drawInlineInput_(place);
    if (!isEmpty(place) || this.info_.isInsertionMarker) return;
    this.used.add(place.input.name);
    const word = wordOn(this.block_, place.input.name);
    word.textContent = wordOf(place.input);
    word.setAttribute("x", String(place.xPos + place.width / 2));
    word.setAttribute("y", String(place.centerline));
  }
}

function wordOn(block: Block, name: string): SVGTextElement {
  const words = shown.get(block) ?? new Map<string, SVGTextElement>();
  shown.set(block, words);
  const known = words.get(name);
  if (known) return known;
  const { Svg, dom } = Blockly.utils;
  // A screen reader hears that the place is empty.
  const word = dom.createSvgElement(Svg.TEXT, { class: "lbSlotWord", "aria-hidden": "true" }, block.getSvgRoot());
  words.set(name, word);
  return word;
}

export class Renderer extends Blockly.zelos.Renderer {
  protected override makeRenderInfo_(block: Block): Blockly.zelos.RenderInfo {
    arrangeOptional(block);
    const room = this.roomOf(block);
    return this.infoOf(block, room !== null && this.isWider(block, room) ? room : null);
  }

  /** The width that a block may have, in units of the workspace; null for any width. */
  protected roomOf(block: Block): number | null {
    return roomBeside(block);
  }

  protected infoOf(block: Block, room: number | null): Info {
    return new Info(this, block, room);
  }

  /** Whether a block on one line is wider than a room. */
  private isWider(block: Block, room: number): boolean {
    const info = this.infoOf(block, null);
    info.measure();
    return info.width > room;
  }

  protected override makeDrawer_(block: Block, info: Blockly.blockRendering.RenderInfo): Blockly.zelos.Drawer {
    return new Drawer(block, info as Blockly.zelos.RenderInfo);
  }
}

/** Call it once, before the first workspace is created. */
export function labelPlaces(): void {
  Blockly.registry.register(Blockly.registry.Type.RENDERER, NAME, Renderer, true);
  // As with Blockly's own renderers: a preview is an outline, not a block.
  Blockly.InsertionMarkerPreviewer.useFastInsertionMarkers = true;
}
