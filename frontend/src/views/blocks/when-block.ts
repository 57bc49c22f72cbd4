/** `when`: with or without a condition, and with its name used by other blocks. */

import * as Blockly from "blockly/core";

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
  return block.getInput("CONDITION") !== null;
}

/** The names of a workspace's `when`s, in its order. */
export function whenNames(workspace: Blockly.Workspace): string[] {
  const names = workspace.getBlocksByType("lb_when", false).map((block) => String(block.getFieldValue("NAME")));
  return [...new Set(names)];
}

/** A free name for a `when`: the requested one, or that with a number. */
export function freeWhenName(workspace: Blockly.Workspace, wish: string): string {
  const taken = new Set(whenNames(workspace));
  let name = wish;
  for (let number = 2; taken.has(name); number++) name = `${wish}${number}`;
  return name;
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

export function registerWhen(): void {
  Blockly.Extensions.registerMutator("lb_when_mutator", SHAPE, function (this: When) {
    showButton(this, hasCondition(this));
    this.getField("NAME")?.setValidator(renameUses);
  });
  Blockly.Extensions.register("lb_when_names", offerNames);
}
