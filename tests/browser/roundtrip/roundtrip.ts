/** The page's editor of blocks alone, for a test that shows it one program after the other. */

import { Editor } from "../../../frontend/src/blocks/editor";
import { fetchPalette, installPalette, prepareBlockly } from "../../../frontend/src/blocks/palette";
import type { Workspace } from "../../../frontend/src/messages";

const ACTIONS = {
  undo: () => undefined,
  redo: () => undefined,
  canUndo: () => false,
  canRedo: () => false,
  toggleBreakpoint: () => undefined,
  hasBreakpoint: () => false,
  show: () => undefined,
  shownBlocks: () => ({ name: "everything" }),
  ownBlocks: () => new Set<string>(),
  tagNames: () => [],
  listOwnBlocks: () => undefined,
  newOwnBlock: () => undefined,
  editOwnBlock: () => undefined,
};

async function begin(host: HTMLElement): Promise<void> {
  const palette = await fetchPalette("en");
  prepareBlockly();
  installPalette(palette);
  const editor = new Editor(host, palette, "light", ACTIONS, () => undefined);
  const roundTrip = (workspace: Workspace): Workspace => {
    editor.show(workspace);
    return editor.read();
  };
  Object.assign(globalThis, { roundTrip });
}

void begin(document.getElementById("blocks")!);
