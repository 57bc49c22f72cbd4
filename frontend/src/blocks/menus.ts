/** Blockly's keys and context menus, with undo that is the server's and what only we have. */

import * as Blockly from "blockly/core";

import { t } from "../i18n";
import type { BlockSet } from "../messages";
import { hasCondition, toggleCondition, toggleWord } from "./when_block";

/** What menus and keys of a workspace do. */
export interface Actions {
  undo(): void;
  redo(): void;
  canUndo(): boolean;
  canRedo(): boolean;
  toggleBreakpoint(block: string): void;
  hasBreakpoint(block: string): boolean;
  /** Show a block in the texts. */
  show(block: string): void;
  /** Which blocks the palette offers. */
  shownBlocks(): BlockSet;
  /** The names of the skills that the user has made. */
  ownBlocks(): ReadonlySet<string>;
  /** The names in the dictionary of tags. */
  tagNames(): readonly string[];
  listOwnBlocks(): void;
  newOwnBlock(): void;
  /** Open the source of a skill that the user has made. */
  editOwnBlock(skill: string): void;
}

/** Begins the type of the block of a skill; the skill's name follows. */
export const SKILL = "lb_skill_";

type Item = Blockly.ContextMenuRegistry.RegistryItem;
type Scope = Blockly.ContextMenuRegistry.Scope;

const { CTRL_CMD, SHIFT, Z, Y, F9 } = Blockly.utils.KeyCodes as unknown as Record<string, number>;
const { FOCUS_TOOLBOX, FOCUS_WORKSPACE, START_MOVE, START_MOVE_STACK } = Blockly.ShortcutItems.names;
const actions = new WeakMap<Blockly.Workspace, Actions>();

/** Give a workspace its own actions. */
export function setActions(workspace: Blockly.Workspace, own: Actions): void {
  actions.set(workspace, own);
}

/** Those of a workspace, or of the one beside a palette. */
export function actionsOf(workspace: Blockly.Workspace | undefined): Actions | undefined {
  const main = workspace?.isFlyout ? (workspace as Blockly.WorkspaceSvg).targetWorkspace : workspace;
  return main ? actions.get(main) : undefined;
}

/** Replace and add keys and menu entries, for all workspaces at once. */
export function registerMenus(): void {
  replaceKey("undo", [[Z, CTRL_CMD]], (own) => own.undo());
  replaceKey("redo", [[Z, CTRL_CMD, SHIFT], [Y, CTRL_CMD]], (own) => own.redo());
  registerBreakpointKey();
  // A letter that is typed in a list would leave the list open behind it.
  for (const name of [FOCUS_TOOLBOX, FOCUS_WORKSPACE]) narrow(name, () => !Blockly.getFocusManager().ephemeralFocusTaken());
  // Blockly cannot move by keys what the mouse holds: it would never let it go.
  for (const name of [START_MOVE, START_MOVE_STACK]) narrow(name, () => !Blockly.Gesture.inProgress());
  for (const item of [undoItem, redoItem, breakpointItem, showItem, editOwnItem, conditionItem]) replaceItem(item);
}

function replaceKey(name: string, keys: (number | undefined)[][], act: (own: Actions) => void): void {
  const registry = Blockly.ShortcutRegistry.registry;
  registry.unregister(name);
  registry.register({
    name,
    keyCodes: keys.map(([key, ...modifiers]) => registry.createSerializedKey(key!, modifiers as number[])),
    preconditionFn: (workspace) => !workspace.isDragging() && !Blockly.getFocusManager().ephemeralFocusTaken(),
    callback: (workspace, event) => {
      const own = actionsOf(workspace);
      event.preventDefault();
      if (own) act(own);
      return own !== undefined;
    },
  });
}

/** Have a key of Blockly's do what it does only where that is allowed. */
function narrow(name: string, allowed: () => boolean): void {
  const registry = Blockly.ShortcutRegistry.registry;
  const shortcut = registry.getRegistry()[name]!;
  registry.unregister(name);
  registry.register({
    ...shortcut,
    preconditionFn: (...where) => allowed() && (shortcut.preconditionFn?.(...where) ?? true),
  });
}

function registerBreakpointKey(): void {
  Blockly.ShortcutRegistry.registry.register({
    name: "lb_breakpoint",
    keyCodes: [F9!],
    preconditionFn: (workspace) => !workspace.isFlyout && focusedStatement(workspace) !== null,
    callback: (workspace) => {
      const block = focusedStatement(workspace);
      if (block) actionsOf(workspace)?.toggleBreakpoint(block.id);
      return block !== null;
    },
  });
}

function focusedStatement(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg | null {
  const node = Blockly.getFocusManager().getFocusedNode();
  const block = node && workspace.getNavigator().getSourceBlockFromNode(node);
  return block ? statementOf(block) : null;
}

/** The statement that a block is, or is a part of; a hat is none. */
export function statementOf(block: Blockly.BlockSvg): Blockly.BlockSvg | null {
  let outer: Blockly.BlockSvg | null = block;
  while (outer?.outputConnection) outer = outer.getParent();
  return outer?.previousConnection ? outer : null;
}

function replaceItem(item: Item): void {
  const registry = Blockly.ContextMenuRegistry.registry;
  if (registry.getItem(item.id)) registry.unregister(item.id);
  registry.register(item);
}

const undoItem: Item = {
  id: "undoWorkspace",
  weight: 1,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.WORKSPACE,
  displayText: () => Blockly.Msg["UNDO"]!,
  preconditionFn: ({ workspace }: Scope) => (actionsOf(workspace)?.canUndo() ? "enabled" : "disabled"),
  callback: ({ workspace }: Scope) => actionsOf(workspace)?.undo(),
};

const redoItem: Item = {
  id: "redoWorkspace",
  weight: 2,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.WORKSPACE,
  displayText: () => Blockly.Msg["REDO"]!,
  preconditionFn: ({ workspace }: Scope) => (actionsOf(workspace)?.canRedo() ? "enabled" : "disabled"),
  callback: ({ workspace }: Scope) => actionsOf(workspace)?.redo(),
};

const breakpointItem: Item = {
  id: "lb_breakpoint",
  weight: 8,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: ({ block }: Scope) => t(hasStop(block) ? "blocks.remove_breakpoint" : "blocks.add_breakpoint"),
  preconditionFn: ({ block }: Scope) => (block && !block.isInFlyout && statementOf(block) ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => actionsOf(block?.workspace)?.toggleBreakpoint(statementOf(block!)!.id),
};

function hasStop(block: Blockly.BlockSvg | undefined): boolean {
  const statement = block && statementOf(block);
  return !!statement && !!actionsOf(block.workspace)?.hasBreakpoint(statement.id);
}

const showItem: Item = {
  id: "lb_show",
  weight: 9,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: () => t("blocks.show_in_texts"),
  preconditionFn: ({ block }: Scope) => (block && !block.isInFlyout ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => actionsOf(block?.workspace)?.show((statementOf(block!) ?? block!).id),
};

const editOwnItem: Item = {
  id: "lb_edit_own",
  weight: 10,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: () => t("blocks.edit_own"),
  preconditionFn: ({ block }: Scope) => (actionsOf(block?.workspace)?.ownBlocks().has(skillOf(block)) ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => actionsOf(block?.workspace)?.editOwnBlock(skillOf(block)),
};

function skillOf(block: Blockly.BlockSvg | undefined): string {
  return block?.type.startsWith(SKILL) ? block.type.slice(SKILL.length) : "";
}

const conditionItem: Item = {
  id: "lb_condition",
  weight: 0,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: ({ block }: Scope) => toggleWord(!!block && hasCondition(block)),
  preconditionFn: ({ block }: Scope) => (block?.type === "lb_when" && !block.isInFlyout ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => toggleCondition(block!),
};
