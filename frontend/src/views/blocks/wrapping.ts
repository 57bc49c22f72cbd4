/** Breaks sentences into lines: those of the palette, so that they are whole beside the program, and all on a phone. */

import * as Blockly from "blockly/core";

import { arrangeOptional } from "./optional";

type Row = Blockly.blockRendering.Row;
type Measurable = Blockly.blockRendering.Measurable;

/** Between two parts of a sentence, and at the edges of statements and of values, in units of the workspace. */
const BETWEEN = 8;
const EDGES = { statement: 24, value: 64 };
/** A line does not begin with a unit or a comma: they belong to the number before them. */
const UNIT = /^\s*([,.:%°)]|(mm|cm|s|ms|Hz)(?!\p{L}))/u;

/** A word or a value of a sentence. */
interface Part {
  readonly width: number;
  /** Whether a line may begin here: with words, but not with a value, which belongs to the words before it. */
  readonly begins: boolean;
  /** Whether it stays with the part before it even where no words can begin a line, as a unit does. */
  readonly follows?: boolean;
}

/** The lines of a row in a room of this width; the row itself if it fits, or holds statements. */
export function linesOf(
  row: Row,
  block: Blockly.BlockSvg,
  room: number,
  constants: Blockly.blockRendering.ConstantProvider,
): Row[] {
  const starts = row.hasStatement ? [] : lineStarts(row.elements.map(partOf), inside(block, room));
  if (!starts.length) return [row];
  const ends = [...starts, row.elements.length];
  return [0, ...starts].map((start, at) => lineOf(row, row.elements.slice(start, ends[at]), constants));
}

function inside({ outputConnection }: Blockly.BlockSvg, room: number): number {
  return room - (outputConnection ? EDGES.value : EDGES.statement);
}

/** A line of some elements of a row. */
export function lineOf(row: Row, elements: Measurable[], constants: Blockly.blockRendering.ConstantProvider): Row {
  const line = new Blockly.blockRendering.InputRow(constants);
  line.elements = elements;
  line.align = row.align;
  line.hasInlineInput = elements.some((element) => element instanceof Blockly.blockRendering.InlineInput);
  line.hasDummyInput = !line.hasInlineInput;
  return line;
}

/** The parts that begin a line after the first, by their places. */
export function lineStarts(parts: readonly Part[], room: number): number[] {
  const starts: number[] = [];
  for (let at = 1; at < parts.length; at++) {
    const start = starts.at(-1) ?? 0;
    if (widthOf(parts.slice(start, at + 1)) <= room) continue;
    starts.push(nextStart(parts, start, at));
  }
  return starts;
}

/** Where the line after one that is full at a part begins: with words, or else with a value and its unit. */
function nextStart(parts: readonly Part[], start: number, full: number): number {
  const ahead = parts.slice(start + 1, full + 1);
  const words = ahead.findLastIndex(({ begins }) => begins);
  const value = ahead.findLastIndex(({ follows }) => !follows);
  const offset = words >= 0 ? words : value;
  return offset >= 0 ? start + 1 + offset : full;
}

function widthOf(parts: readonly Part[]): number {
  return parts.reduce((sum, { width }) => sum + width + BETWEEN, -BETWEEN);
}

function partOf(element: Measurable, at: number, all: readonly Measurable[]): Part {
  const field = fieldOf(element);
  // The icon of a statement is no line of its own.
  const isFirst = at === 1 && fieldOf(all[0]) instanceof Blockly.FieldImage;
  const isWords = field instanceof Blockly.FieldLabel;
  const isUnit = isWords && UNIT.test(field.getText());
  // The button that shows more, or the words after the icon of a statement.
  const follows = isUnit || isFirst || field instanceof Blockly.FieldImage;
  return { width: element.width, begins: isWords && !isFirst && !isUnit, follows };
}

function fieldOf(element: Measurable | undefined): Blockly.Field | null {
  return element instanceof Blockly.blockRendering.Field ? element.field : null;
}

/** Split words that are longer than a line. This changes the palette's block only, not those that are made from it. */
export function splitWords(block: Blockly.BlockSvg, room: number): void {
  arrangeOptional(block);
  for (const input of block.inputList.filter((one) => one.isVisible())) {
    // Each half may be too long, too.
    for (let at = 0; at < input.fieldRow.length; at++) splitField(input, at, inside(block, room));
  }
}

function splitField(input: Blockly.Input, at: number, room: number): void {
  const field = input.fieldRow[at];
  if (!(field instanceof Blockly.FieldLabel) || !field.isVisible() || field.getSize().width <= room) return;
  const text = field.getText();
  const end = lastSpace(text, (room * text.length) / field.getSize().width);
  if (end <= 0) return;
  input.insertFieldAt(at, text.slice(0, end));
  field.setValue(text.slice(end + 1));
}

/** The place of the last space that is not beyond an end, whatever kind it is; -1 if there is none. */
function lastSpace(text: string, end: number): number {
  const spaces = [...text.matchAll(/\s/gu)].map(({ index }) => index);
  return spaces.findLast((at) => at <= end) ?? -1;
}
