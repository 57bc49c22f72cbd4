/** The page's editor of blocks alone, for a test that shows it one program after the other. */

import { BlockEditor } from "../../../frontend/src/views/blocks/editor";
import { fetchPalette, installPalette, prepareBlockly } from "../../../frontend/src/views/blocks/palette";
import type { Workspace } from "../../../frontend/src/protocol/messages";

const ACTIONS = {
  undo: () => undefined,
  redo: () => undefined,
  canUndo: () => false,
  canRedo: () => false,
  toggleBreakpoint: () => undefined,
  hasBreakpoint: () => false,
  show: () => undefined,
  shownBlocks: () => ({ name: "everything" }),
  customBlocks: () => new Set<string>(),
  tagNames: () => [],
  listCustomBlocks: () => undefined,
  newCustomBlock: () => undefined,
  editCustomBlock: () => undefined,
};

async function begin(host: HTMLElement): Promise<void> {
  const palette = await fetchPalette("en");
  prepareBlockly();
  installPalette(palette);
  const editor = new BlockEditor(host, palette, "light", ACTIONS, () => undefined);
  const roundTrip = async (workspace: Workspace): Promise<Workspace> => {
    editor.show(workspace);
    await new Promise<void>((done) => editor.whenLoaded(done));
    return editor.read();
  };
  Object.assign(globalThis, { roundTrip });
}

void begin(document.getElementById("blocks")!);
