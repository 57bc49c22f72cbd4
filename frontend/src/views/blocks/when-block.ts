/** `when`: with or without a condition or ready with one, and with its name used by other blocks. */

import * as Blockly from "blockly/core";

import { freeName } from "../../model/own-block-names";
import { READY_HATS, WHENS } from "../../model/whens";
import { FreeChoice } from "./fields/free-choice";
import { renameHidden } from "./rest-block";
import { changeShape, stepButton } from "./step-button";

interface WhenState {
  condition: boolean;
}
type When = Blockly.Block & { setCondition(on: boolean): void };

/** Blocks that refer to a `when` by its name. */
const USES = ["lb_activate", "lb_deactivate", "lb_state", "lb_time"];

const SHAPE = {
  saveExtraState(this: Blockly.Block): WhenState {
    return { condition: this.getInput("CONDITION") !== null };
  },
  loadExtraState(this: When, state: WhenState): void {
    this.setCondition(state.condition);
  },
  setCondition(this: When, on: boolean): void {
    if (on === (this.getInput("CONDITION") !== null)) return;
    if (on) {
      this.appendValueInput("CONDITION")
        .setCheck("Boolean")
        .appendField(Blockly.Msg.LB_WHEN_CONDITION ?? "=");
      this.moveInputBefore("CONDITION", "DO");
    } else {
      this.removeInput("CONDITION");
    }
    showButton(this, on);
  },
};

function showButton(block: When, hasCondition: boolean): void {
  const row = block.getInput("PLACE");
  if (block.getField("TOGGLE")) row?.removeField("TOGGLE");
  const button = stepButton(hasCondition ? "−" : "+", toggleWord(hasCondition), () =>
    block.setCondition(!hasCondition),
  );
  row?.appendField(button, "TOGGLE");
}

/** The menu text for removing or adding the condition. */
export function toggleWord(hasCondition: boolean): string {
  return Blockly.Msg[hasCondition ? "LB_WHEN_REMOVE_CONDITION" : "LB_WHEN_ADD_CONDITION"] ?? "";
}

/** Adds or removes the condition of a `when`, as an edit by the user. */
export function toggleCondition(block: Blockly.Block): void {
  const when = block as When;
  changeShape(when, () => when.setCondition(when.getInput("CONDITION") === null));
}

export function hasCondition(block: Blockly.Block): boolean {
  return block.type !== "lb_when" || block.getInput("CONDITION") !== null;
}

/** The `when`s of a workspace, in its order. */
export function whensOf(workspace: Blockly.Workspace): Blockly.Block[] {
  const whens = new Set(WHENS);
  return workspace.getTopBlocks(true).filter(({ type }) => whens.has(type));
}

/** The names of a workspace's `when`s, in its order. */
export function whenNames(workspace: Blockly.Workspace): string[] {
  return [...new Set(whensOf(workspace).map((block) => String(block.getFieldValue("NAME"))))];
}

/** A free name for a `when`: the requested one, or that with a number. */
export function freeWhenName(workspace: Blockly.Workspace, wish: string): string {
  return freeName(wish, whenNames(workspace));
}

// A validator runs before the block has the new name.
function renameUses(this: Blockly.Field, wish: string): string | null {
  const block = this.getSourceBlock();
  if (!block || block.isInFlyout || !Blockly.Events.isEnabled()) return wish;
  const old = String(this.getValue());
  const name = wish.trim();
  if (!name || (name !== old && whenNames(block.workspace).includes(name))) return null;
  for (const use of usesOf(block.workspace, old)) use.setFieldValue(name, "WHEN");
  renameHidden(block.workspace, USES, old, name);
  return name;
}

function usesOf(workspace: Blockly.Workspace, name: string): Blockly.Block[] {
  return USES.flatMap((type) => workspace.getBlocksByType(type, false)).filter(
    (block) => block.getFieldValue("WHEN") === name,
  );
}

/** A choice among the `when`s, including later ones. */
class FieldWhen extends FreeChoice {
  constructor() {
    super(choices);
  }
}

function choices(this: Blockly.FieldDropdown): Blockly.MenuOption[] {
  const block = this.getSourceBlock();
  const names = new Set(block ? whenNames(targetOf(block.workspace)) : []);
  const own = this.getValue();
  if (own || !names.size) names.add(own ?? "");
  return [...names].map((name) => [name, name]);
}

// In the palette, use the names of the workspace beside it.
function targetOf(workspace: Blockly.Workspace): Blockly.Workspace {
  return (workspace as Blockly.WorkspaceSvg).targetWorkspace ?? workspace;
}

function offerNames(this: Blockly.Block): void {
  this.getInput("PLACE")?.appendField(new FieldWhen() as Blockly.Field, "WHEN");
}

/** The name of a ready hat, whose sentence says enough: it is shown only while another block uses it. */
class NameOfHat extends Blockly.FieldTextInput {
  // Blockly reads hidden fields, too.
  override getText(): string {
    return this.isVisible() ? super.getText() : "";
  }
}

function addName(this: Blockly.Block): void {
  const name = new NameOfHat("", renameUses);
  this.appendDummyInput("NAMED").appendField(name, "NAME");
  this.moveInputBefore("NAMED", "DO");
  name.setVisible(false);
}

/** Show the names of the ready hats that other blocks use, and hide those of the others. */
export function showUsedNames(workspace: Blockly.WorkspaceSvg): void {
  const used = new Set(USES.flatMap((type) => workspace.getBlocksByType(type, false)).map(whenOf));
  for (const hat of READY_HATS.flatMap((type) => workspace.getBlocksByType(type, false))) {
    const name = hat.getField("NAME");
    const isUsed = used.has(hat.getFieldValue("NAME"));
    if (!name || name.isVisible() === isUsed || hat.isCollapsed()) continue;
    name.setVisible(isUsed);
    name.forceRerender();
  }
}

function whenOf(use: Blockly.Block): unknown {
  return use.getFieldValue("WHEN");
}

export function registerWhen(): void {
  Blockly.Extensions.registerMutator("lb_when_mutator", SHAPE, function (this: When) {
    showButton(this, hasCondition(this));
    this.getField("NAME")?.setValidator(renameUses);
  });
  Blockly.Extensions.register("lb_when_names", offerNames);
  Blockly.Extensions.register("lb_when_name", addName);
}
