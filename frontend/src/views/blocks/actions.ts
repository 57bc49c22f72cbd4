/** The actions that a workspace's menus and keys call outside the workspace. */

import type * as Blockly from "blockly/core";

import type { BlockSet } from "../../protocol/messages";

export interface Actions {
  undo(): void;
  redo(): void;
  canUndo(): boolean;
  canRedo(): boolean;
  toggleBreakpoint(block: string): void;
  hasBreakpoint(block: string): boolean;
  /** Show a block in the text views. */
  show(block: string): void;
  /** The set of blocks in the palette. */
  shownBlocks(): BlockSet;
  /** The names of the skills of custom blocks. */
  customBlocks(): ReadonlySet<string>;
  /** The names in the tag dictionary. */
  tagNames(): readonly string[];
  listCustomBlocks(): void;
  newCustomBlock(): void;
  /** Open the source of a custom block by its skill. */
  editCustomBlock(skill: string): void;
}

const actions = new WeakMap<Blockly.Workspace, Actions>();

/** Set the actions of a workspace. */
export function setActions(workspace: Blockly.Workspace, own: Actions): void {
  actions.set(workspace, own);
}

/** The actions of a workspace, or of the workspace beside a palette. */
export function actionsOf(workspace: Blockly.Workspace | undefined): Actions | undefined {
  const main = workspace?.isFlyout ? (workspace as Blockly.WorkspaceSvg).targetWorkspace : workspace;
  return main ? actions.get(main) : undefined;
}
