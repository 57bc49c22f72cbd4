/** The page's editor of blocks alone, for a browser test that shows it one program after the other. */

import type { Workspace } from "../../src/protocol/messages";
import type { BlockActions } from "../../src/views/blocks/actions";
import { BlockEditor } from "../../src/views/blocks/editor";
import { fetchPalette, installPalette, prepareBlockly } from "../../src/views/blocks/palette";

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
  const roundTrip = async (workspace: Workspace): Promise<Workspace> => {
    editor.show(workspace);
    await new Promise<void>((done) => editor.whenLoaded(done));
    return editor.read();
  };
  Object.assign(globalThis, { roundTrip });
}

void begin(document.getElementById("blocks")!);
