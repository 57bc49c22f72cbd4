/** Blocks for a phone: words as large as elsewhere, less around them, and long sentences in several lines. */

import * as Blockly from "blockly/core";

import { LEAST, MARGIN } from "./fit";
import { Info, Renderer } from "./renderer";
import { lineOf } from "./wrapping";

type Row = Blockly.blockRendering.Row;

/** The name of the renderer. */
export const COMPACT = "zelos-compact";

/** What Blockly's paddings, notches and corners are made of, in units of the workspace; elsewhere it is 4. */
const GRID_UNIT = 3.25;
/** Elsewhere they are 22, and six of these units. */
const HAT = 14;
const FOOT = 3 * GRID_UNIT;
/** How far a statement is to the right of the one around it, and what is beside a value on a line of its own. */
const INDENT = 4 * GRID_UNIT;
const EDGES = 8 * GRID_UNIT;
/** The height of a line with "else". */
const LINE = 8 * GRID_UNIT;
/** The narrowest room of a sentence: deep inside, a program is scrolled. */
const NARROWEST = 260;
/** The mouths of loops and conditions, but not those of "else". */
const MOUTH = /^DO\d*$/;

class Constants extends Blockly.zelos.ConstantProvider {
  constructor() {
    super(GRID_UNIT);
    this.START_HAT_HEIGHT = HAT;
    this.BOTTOM_ROW_AFTER_STATEMENT_MIN_HEIGHT = FOOT;
  }
}

class CompactInfo extends Info {
  protected override createRows_(): void {
    super.createRows_();
    const { InputRow } = Blockly.blockRendering;
    this.rows = this.rows.flatMap((row) => (row.hasStatement ? this.wordsAbove(row) : [row]));
    this.inputRows = this.rows.filter((row) => row instanceof InputRow);
  }

  /** Words beside a mouth, such as "else", would move all that is inside to the right. */
  private wordsAbove(row: Row): Row[] {
    const { Types } = Blockly.blockRendering;
    const words = row.elements.filter((element) => !Types.isStatementInput(element) && element.width > 0);
    row.elements = row.elements.filter((element) => Types.isStatementInput(element));
    if (words.length === 0) return [row];
    const line = lineOf(row, words, this.constants_);
    line.minHeight = LINE;
    return [line, row];
  }
}

class CompactRenderer extends Renderer {
  protected override makeConstants_(): Blockly.zelos.ConstantProvider {
    return new Constants();
  }

  protected override makeRenderInfo_(block: Blockly.BlockSvg): Blockly.zelos.RenderInfo {
    hideDo(block);
    return super.makeRenderInfo_(block);
  }

  protected override roomOf(block: Blockly.BlockSvg): number | null {
    return super.roomOf(block) ?? roomIn(block);
  }

  protected override infoOf(block: Blockly.BlockSvg, room: number | null): Info {
    return new CompactInfo(this, block, room);
  }
}

/** "do" before a mouth says nothing that its shape does not say. */
function hideDo(block: Blockly.BlockSvg): void {
  const mouths = block.inputList.filter(({ name }) => MOUTH.test(name));
  for (const field of mouths.flatMap(({ fieldRow }) => fieldRow)) field.setVisible(false);
}

/** The width of the view at the smallest size of the blocks, without what is around this one. */
function roomIn(block: Blockly.BlockSvg): number {
  let room = (block.workspace.getCachedParentSvgSize().width - 2 * MARGIN) / LEAST;
  for (let one = block, around = one.getSurroundParent(); around; one = around, around = one.getSurroundParent()) {
    room -= one.outputConnection ? EDGES : INDENT;
  }
  return Math.max(NARROWEST, room);
}

/** Call it once, before the first workspace is created. */
export function registerCompact(): void {
  Blockly.registry.register(Blockly.registry.Type.RENDERER, COMPACT, CompactRenderer, true);
}
