/** Blockly's keys and context menus, with the server's undo and LearnBlock's own entries. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import "./menus.css";
import { actionsOf, type BlockActions } from "./actions";
import { showHelp } from "./help";
import { definitionOf } from "./own-blocks";
import { KEYS, leaveOutSelection } from "./patches";
import { hasCondition, toggleCondition, toggleWord } from "./when-block";

/** The prefix of a skill block's type; the skill's name follows. */
export const SKILL = "lb_skill_";

type Item = Blockly.ContextMenuRegistry.RegistryItem;
type Scope = Blockly.ContextMenuRegistry.Scope;

const { CTRL_CMD, SHIFT, I, Z, Y, F9 } = KEYS;
const { COPY, CUT, FOCUS_TOOLBOX, FOCUS_WORKSPACE, START_MOVE, START_MOVE_STACK } = Blockly.ShortcutItems.names;

/** Replace and add keys and menu entries, for all workspaces at once. */
export function registerMenus(): void {
  replaceKey("undo", [[Z, CTRL_CMD]], (own) => own.undo());
  replaceKey(
    "redo",
    [
      [Z, CTRL_CMD, SHIFT],
      [Y, CTRL_CMD],
    ],
    (own) => own.redo(),
  );
  registerBreakpointKey();
  registerHelpKey();
  for (const name of [COPY, CUT]) copyTextToo(name);
  // A letter typed in a list would leave the list open.
  for (const name of [FOCUS_TOOLBOX, FOCUS_WORKSPACE])
    narrow(name, () => !Blockly.getFocusManager().ephemeralFocusTaken());
  // The palette's blocks have a workspace of their own, which has no tabs.
  widen(FOCUS_TOOLBOX);
  // Blockly cannot move a block by keys during a drag: the drag would never end.
  for (const name of [START_MOVE, START_MOVE_STACK]) narrow(name, () => !Blockly.Gesture.inProgress());
  for (const item of [
    undoItem,
    redoItem,
    helpItem,
    whyItem,
    breakpointItem,
    showItem,
    editOwnItem,
    conditionItem,
    changeBlockItem,
  ])
    replaceItem(item);
  commentStatementsOnly();
  countWithoutShadows();
  joinLinesOnly();
  for (const by of [-1, 1] as const) replaceItem(runItem(by));
  leaveOutSelection();
}

/** The texts have no place for the comment of a value: only what has one can lose it. */
function commentStatementsOnly(): void {
  restrictItem("blockComment", (block) => !block.outputConnection || block.hasIcon(Blockly.icons.CommentIcon.TYPE));
}

/** A sentence is on one line; programs from elsewhere may have blocks with a line for each value. */
function joinLinesOnly(): void {
  restrictItem("blockInline", (block) => !block.getInputsInline());
}

/** Show one of Blockly's entries for some blocks only. */
function restrictItem(id: string, allows: (block: Blockly.BlockSvg) => boolean): void {
  const item = itemOf(id);
  const preconditionFn = (scope: Scope, opening: Event) =>
    scope.block && !allows(scope.block) ? "hidden" : item.preconditionFn(scope, opening);
  replaceItem({ ...item, preconditionFn } as Item);
}

/** A block with its usual values is one block, as children count. */
function countWithoutShadows(): void {
  const displayText = ({ block }: Scope) => {
    const count = block ? countOf(block) : 1;
    const words = Blockly.Msg[count === 1 ? "DELETE_BLOCK" : "DELETE_X_BLOCKS"] ?? "";
    return words.replace("%1", String(count));
  };
  replaceItem({ ...itemOf("blockDelete"), displayText } as Item);
}

/** The blocks that are deleted with a block: those inside it, but not those below. */
function countOf(block: Blockly.BlockSvg): number {
  const below = new Set(block.getNextBlock()?.getDescendants(false));
  return block.getDescendants(false).filter((one) => !one.isShadow() && !below.has(one)).length;
}

type Conditional = Item & { preconditionFn: (scope: Scope, opening: Event) => string };

function itemOf(id: string): Conditional {
  return Blockly.ContextMenuRegistry.registry.getItem(id) as Conditional;
}

function replaceKey(name: string, keys: (number | undefined)[][], act: (own: BlockActions) => void): void {
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

/** Restrict one of Blockly's keys by a condition. */
function narrow(name: string, allowed: () => boolean): void {
  const registry = Blockly.ShortcutRegistry.registry;
  const shortcut = registry.getRegistry()[name]!;
  registry.unregister(name);
  registry.register({
    ...shortcut,
    preconditionFn: (...where) => allowed() && (shortcut.preconditionFn?.(...where) ?? true),
  });
}

/** Let one of Blockly's keys act on the program also while a block of the palette has the focus. */
function widen(name: string): void {
  const registry = Blockly.ShortcutRegistry.registry;
  const shortcut = registry.getRegistry()[name]!;
  registry.unregister(name);
  registry.register({
    ...shortcut,
    callback: (workspace, ...how) => shortcut.callback?.(workspace.targetWorkspace ?? workspace, ...how) ?? false,
  });
}

/** Let one of Blockly's keys copy the text of a block, too: before it may be gone. */
function copyTextToo(name: string): void {
  const registry = Blockly.ShortcutRegistry.registry;
  const shortcut = registry.getRegistry()[name]!;
  registry.unregister(name);
  registry.register({
    ...shortcut,
    callback: (workspace, ...how) => {
      const block = focusedBlock(workspace);
      if (block && !workspace.isFlyout && !block.outputConnection) actionsOf(workspace)?.copied(block.id);
      return shortcut.callback?.(workspace, ...how) ?? false;
    },
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

function registerHelpKey(): void {
  const registry = Blockly.ShortcutRegistry.registry;
  registry.register({
    name: "lb_help",
    keyCodes: [registry.createSerializedKey(I!, [CTRL_CMD!])],
    preconditionFn: (workspace) => focusedBlock(workspace) !== null,
    callback: (workspace, event) => {
      event.preventDefault();
      return explainFocused(workspace);
    },
  });
}

/** Show the help on the block with the focus; return whether there is one. */
export function explainFocused(workspace: Blockly.WorkspaceSvg): boolean {
  const block = focusedBlock(workspace);
  if (block) showHelp(block);
  return block !== null;
}

function focusedBlock(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg | null {
  const node = Blockly.getFocusManager().getFocusedNode();
  return node ? workspace.getNavigator().getSourceBlockFromNode(node) : null;
}

function focusedStatement(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg | null {
  const block = focusedBlock(workspace);
  return block ? statementOf(block) : null;
}

/** The statement that a block is or belongs to; null for a hat. */
function statementOf(block: Blockly.BlockSvg): Blockly.BlockSvg | null {
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
  displayText: () => Blockly.Msg.UNDO!,
  preconditionFn: ({ workspace }: Scope) => (actionsOf(workspace)?.canUndo() ? "enabled" : "disabled"),
  callback: ({ workspace }: Scope) => actionsOf(workspace)?.undo(),
};

const redoItem: Item = {
  id: "redoWorkspace",
  weight: 2,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.WORKSPACE,
  displayText: () => Blockly.Msg.REDO!,
  preconditionFn: ({ workspace }: Scope) => (actionsOf(workspace)?.canRedo() ? "enabled" : "disabled"),
  callback: ({ workspace }: Scope) => actionsOf(workspace)?.redo(),
};

/** In place of Blockly's, which opens a page of the internet. */
const helpItem: Item = {
  id: "blockHelp",
  weight: 7,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: () => t("page-blocks-help"),
  preconditionFn: ({ block }: Scope) => (block ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => showHelp(block!),
};

/** For a statement, once there is a run to look back at. */
function inRun({ block }: Scope): string {
  return block && !block.isInFlyout && statementOf(block) && actionsOf(block.workspace)?.hasRun()
    ? "enabled"
    : "hidden";
}

const whyItem: Item = {
  id: "lb_why",
  weight: 7.5,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: () => t("page-why-ask-block"),
  preconditionFn: inRun,
  callback: ({ block }: Scope) => actionsOf(block?.workspace)?.askWhy(statementOf(block!)!.id),
};

function runItem(by: -1 | 1): Item {
  return {
    id: by < 0 ? "lb_run_before" : "lb_run_after",
    weight: by < 0 ? 7.6 : 7.7,
    scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
    displayText: () => t(by < 0 ? "page-timeline-run-before" : "page-timeline-run-after"),
    preconditionFn: inRun,
    callback: ({ block }: Scope) => actionsOf(block?.workspace)?.goToRun(by, statementOf(block!)!.id),
  };
}

const breakpointItem: Item = {
  id: "lb_breakpoint",
  weight: 8,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: ({ block }: Scope) => t(hasStop(block) ? "page-blocks-remove-breakpoint" : "page-blocks-add-breakpoint"),
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
  displayText: () => t("page-blocks-show-in-texts"),
  preconditionFn: ({ block }: Scope) => (block && !block.isInFlyout ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => actionsOf(block?.workspace)?.show((statementOf(block!) ?? block!).id),
};

const editOwnItem: Item = {
  id: "lb_edit_own",
  weight: 10,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: () => t("page-blocks-edit-own"),
  preconditionFn: ({ block }: Scope) =>
    actionsOf(block?.workspace)?.customBlocks().has(skillOf(block)) ? "enabled" : "hidden",
  callback: ({ block }: Scope) => actionsOf(block?.workspace)?.editCustomBlock(skillOf(block)),
};

function skillOf(block: Blockly.BlockSvg | undefined): string {
  return block?.type.startsWith(SKILL) ? block.type.slice(SKILL.length) : "";
}

const changeBlockItem: Item = {
  id: "lb_change_block",
  weight: 0,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: () => t("page-make-change"),
  preconditionFn: ({ block }: Scope) => (block && !block.isInFlyout && definitionOf(block) ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => changeOwnBlock(block!),
};

/** Open the dialog of the program's block that a block defines or calls; return whether it does. */
export function changeOwnBlock(block: Blockly.BlockSvg): boolean {
  const definition = definitionOf(block);
  if (definition) actionsOf(block.workspace)?.changeBlock(definition.id);
  return definition !== null;
}

const conditionItem: Item = {
  id: "lb_condition",
  weight: 0,
  scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
  displayText: ({ block }: Scope) => toggleWord(!!block && hasCondition(block)),
  preconditionFn: ({ block }: Scope) => (block?.type === "lb_when" && !block.isInFlyout ? "enabled" : "hidden"),
  callback: ({ block }: Scope) => toggleCondition(block!),
};
