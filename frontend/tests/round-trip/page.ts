/** The page's editor of blocks alone, for a browser test that shows it one program after the other. */

import * as Blockly from "blockly/core";

import type { Workspace } from "../../src/protocol/messages";
import type { BlockActions } from "../../src/views/blocks/actions";
import { BlockEditor } from "../../src/views/blocks/editor";
import { fetchPalette, installPalette, prepareBlockly } from "../../src/views/blocks/palette";
import { drawProgram } from "../../src/views/blocks/program-picture";

const nothing = () => undefined;
const ACTIONS: BlockActions = {
  undo: nothing,
  redo: nothing,
  canUndo: () => false,
  canRedo: () => false,
  toggleBreakpoint: nothing,
  hasBreakpoint: () => false,
  hasRun: () => false,
  askWhy: nothing,
  goToRun: nothing,
  copied: nothing,
  select: nothing,
  draw: nothing,
  show: nothing,
  shownBlocks: () => ({ name: "everything" }),
  inGame: () => true,
  robot: () => ({ title: "", lacks: new Set(), all: [], serving: () => "" }),
  customBlocks: () => new Set(),
  tagNames: () => [],
  offered: nothing,
  openExample: nothing,
  makeBlock: nothing,
  changeBlock: nothing,
  listCustomBlocks: nothing,
  newCustomBlock: nothing,
  editCustomBlock: nothing,
};

async function begin(host: HTMLElement): Promise<void> {
  const palette = await fetchPalette("en");
  prepareBlockly();
  installPalette(palette);
  const editor = new BlockEditor(host, palette, "light", ACTIONS, false, nothing, nothing);
  const shown = Blockly.getMainWorkspace();
  const roundTrip = async (workspace: Workspace): Promise<Workspace> => {
    editor.show(workspace);
    await new Promise<void>((done) => editor.whenLoaded(done));
    return editor.read();
  };
  /** How many words a program has, and those that its picture lacks. */
  const wordsOfPicture = async (workspace: Workspace): Promise<readonly [number, readonly string[]]> => {
    await roundTrip(workspace);
    const { svg } = await drawProgram(workspace, { language: "en", theme: "light", text: "", only: null });
    const words = wordsOf(shown);
    return [words.length, missing(words, textsIn(svg))];
  };
  Object.assign(globalThis, { roundTrip, wordsOfPicture });
}

/** The words of all blocks, as they are shown. */
function wordsOf(workspace: Blockly.Workspace): readonly string[] {
  const blocks = workspace.getAllBlocks(false).filter(isShown);
  const inputs = blocks.flatMap(({ inputList }) => inputList);
  const fields = inputs.filter((input) => input.isVisible()).flatMap(({ fieldRow }) => fieldRow);
  const words = fields.filter((field) => field.isVisible() && !isDrawn(field));
  return words
    .flatMap((field) => field.getText().split("\n"))
    .map(plain)
    .filter(Boolean);
}

/** Whether a field is a drawing, such as an icon or a tick. */
function isDrawn(field: Blockly.Field): boolean {
  return field instanceof Blockly.FieldImage || field instanceof Blockly.FieldCheckbox;
}

/** Whether a block is not folded away with the optional values of a block around it. */
function isShown(block: Blockly.Block): boolean {
  const around = block.getParent();
  if (!around) return true;
  return around.getInputWithBlock(block)?.isVisible() !== false && isShown(around);
}

function textsIn(picture: SVGElement): string[] {
  return [...picture.querySelectorAll("text")].map(({ textContent }) => plain(textContent));
}

function plain(text: string): string {
  return text.replaceAll(/\s/g, " ").trim();
}

/** The words that have no text of their own among some, of which long ones are cut. */
function missing(words: readonly string[], texts: string[]): readonly string[] {
  return words.filter((word) => {
    const place = texts.findIndex((text) => text === word || isCut(text, word));
    if (place >= 0) texts.splice(place, 1);
    return place < 0;
  });
}

function isCut(text: string, word: string): boolean {
  return text.endsWith("…") && word.startsWith(text.slice(0, -1));
}

void begin(document.getElementById("blocks")!);
