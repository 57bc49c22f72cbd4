/** The actions that a workspace's menus and keys call outside the workspace. */

import type * as Blockly from "blockly/core";

import type { BlockSet } from "../../protocol/messages";

/** The chosen robot, as far as the palette depends on it. */
export interface OfferedRobot {
  readonly title: string;
  /** The needs of blocks that it can't serve. */
  readonly lacks: ReadonlySet<string>;
  /** The simulated robots, with what each cannot serve. */
  readonly all: readonly { readonly title: string; readonly lacks: readonly string[] }[];
  /** What serves the senses among the needs of a block, as a sentence; empty if it has none. */
  readonly serving: (needs: readonly string[]) => string;
}

export interface BlockActions {
  undo(): void;
  redo(): void;
  canUndo(): boolean;
  canRedo(): boolean;
  toggleBreakpoint(block: string): void;
  hasBreakpoint(block: string): boolean;
  /** Whether there is a run to ask about. */
  hasRun(): boolean;
  askWhy(block: string): void;
  /** Look back at where a block ran, before or after the moment that is shown. */
  goToRun(by: -1 | 1, block: string): void;
  /** Let a block that is copied be pasted as text. */
  copied(block: string): void;
  /** Report the statement that is selected. */
  select(block: string | null): void;
  /** Draw the first statements that a placeholder hides. */
  draw(block: string): void;
  /** Show a block in the text views. */
  show(block: string): void;
  /** The set of blocks in the palette. */
  shownBlocks(): BlockSet;
  robot(): OfferedRobot;
  /** Whether the world or the program has a game. */
  inGame(): boolean;
  /** The names of the skills of custom blocks. */
  customBlocks(): ReadonlySet<string>;
  /** The names in the tag dictionary. */
  tagNames(): readonly string[];
  /** A block as the palette has it, by its type. */
  offered(type: string): object | undefined;
  /** Open the dialog for a new block of the program. */
  makeBlock(): void;
  /** Open the dialog for a block of the program, given by its definition. */
  changeBlock(definition: string): void;
  /** Open an example in Block-Text as a project. */
  openExample(program: string): void;
  listCustomBlocks(): void;
  newCustomBlock(): void;
  /** Open the source of a custom block by its skill. */
  editCustomBlock(skill: string): void;
}

const actions = new WeakMap<Blockly.Workspace, BlockActions>();

/** Set the actions of a workspace. */
export function setActions(workspace: Blockly.Workspace, own: BlockActions): void {
  actions.set(workspace, own);
}

/** The actions of a workspace, or of the workspace beside a palette. */
export function actionsOf(workspace: Blockly.Workspace | undefined): BlockActions | undefined {
  const main = workspace?.isFlyout ? (workspace as Blockly.WorkspaceSvg).targetWorkspace : workspace;
  return main ? actions.get(main) : undefined;
}
