/** The palette's categories whose blocks depend on the program: `when`s, variables and functions. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { preferences, type Stage } from "../../model/preferences";
import { actionsOf } from "./actions";
import { SKILL } from "./menus";
import { callState, definitionsIn, ownBlockOf } from "./own-blocks";
import type { PaletteTab } from "./palette";
import { gameHats, readyHats } from "./ready-hats";
import { freeWhenName, hasCondition, whensOf } from "./when-block";

type Items = Blockly.utils.toolbox.FlyoutItemInfo[];
type Item = Blockly.utils.toolbox.FlyoutItemInfo;

const NEW_WHEN = "LB_NEW_WHEN";
const MAKE_BLOCK = "LB_MAKE_BLOCK";
const OWN = "LB_OWN";
const NEW_OWN = "LB_NEW_OWN";
const ALL_OWN = "LB_ALL_OWN";
const ZERO = { shadow: { type: "math_number", fields: { NUM: 0 } } };

export function registerCategories(workspace: Blockly.WorkspaceSvg): void {
  workspace.registerToolboxCategoryCallback("WHEN", whenItems);
  workspace.registerToolboxCategoryCallback("VARIABLE", variableItems);
  workspace.registerToolboxCategoryCallback("PROCEDURE", procedureItems);
  workspace.registerToolboxCategoryCallback(OWN, ownItems);
  workspace.registerButtonCallback(MAKE_BLOCK, () => actionsOf(workspace)?.makeBlock());
  workspace.registerButtonCallback(NEW_WHEN, () => askForWhen(workspace));
  workspace.registerButtonCallback(NEW_OWN, () => actionsOf(workspace)?.newCustomBlock());
  workspace.registerButtonCallback(ALL_OWN, () => actionsOf(workspace)?.listCustomBlocks());
}

/** The tab of custom blocks. */
export function ownTab(): PaletteTab {
  return { kind: "category", name: t("page-blocks-own"), category: "lb_own", group: "my_blocks", custom: OWN };
}

/** Buttons for creating and listing custom blocks, and the blocks themselves, which are also in their own tabs. */
function ownItems(workspace: Blockly.WorkspaceSvg): Items {
  const names = actionsOf(workspace)?.customBlocks() ?? new Set();
  const offered = (workspace.options.languageTree?.contents ?? []).flatMap(contentsOf);
  const own = offered.filter((item) => item.kind === "block" && names.has(skillOf(item)));
  return [button(NEW_OWN, t("page-blocks-new-own")), button(ALL_OWN, t("page-blocks-all-own")), ...own];
}

function contentsOf(tab: Blockly.utils.toolbox.ToolboxItemInfo): Items {
  return "contents" in tab ? (tab.contents as Items) : [];
}

function skillOf(item: Item): string {
  return "type" in item ? (item.type ?? "").replace(SKILL, "") : "";
}

/** First what is ready; from Explorer on, empty events follow; from Coder on, they can be named at once. */
function whenItems(workspace: Blockly.WorkspaceSvg): Items {
  const { stage } = preferences.peek();
  const ready = readyHats(workspace) as unknown as Items;
  const make = stage === "coder" ? [button(NEW_WHEN, t("page-blocks-new-when"))] : [];
  const empty = stage === "starter" ? [] : emptyWhens(workspace);
  return [...ready, ...gameItems(workspace), ...empty, ...make, ...usesOfWhens(workspace, stage)];
}

function gameItems(workspace: Blockly.WorkspaceSvg): Items {
  const hats = gameHats(workspace) as unknown as Items;
  return hats.length ? [label(t("page-blocks-in-a-game"), "lbHeading"), ...hats] : [];
}

function emptyWhens(workspace: Blockly.WorkspaceSvg): Items {
  const name = freeWhenName(workspace, t("page-blocks-when-name"));
  return [false, true].map((condition) => block("lb_when", { fields: { NAME: name }, extraState: { condition } }));
}

/** A condition starts and stops an event by itself; beginners do without its state, too. */
function usesOfWhens(workspace: Blockly.WorkspaceSvg, stage: Stage): Items {
  const whens = new Map(whensOf(workspace).map((when) => [String(when.getFieldValue("NAME")), hasCondition(when)]));
  return [...whens].flatMap(([name, follows]) => {
    const states = follows && stage === "starter" ? [] : ["lb_state", "lb_time"];
    const switches = follows ? [] : ["lb_activate", "lb_deactivate"];
    return [...switches, ...states].map((type) => block(type, { fields: { WHEN: name } }));
  });
}

function block(type: string, state: object): Item {
  return { kind: "block", type, ...state } as Item;
}

function button(callbackkey: string, text: string, look = ""): Item {
  return { kind: "button", text, callbackkey, ...(look ? { "web-class": look } : {}) } as Item;
}

/** Blockly's blocks; a variable begins with 0, not with nothing. */
function variableItems(workspace: Blockly.WorkspaceSvg): Items {
  const items = Blockly.Variables.flyoutCategory(workspace).map((item) =>
    "type" in item && item.type === "variables_set" ? { ...item, inputs: { VALUE: ZERO } } : item,
  );
  return [...items, ...localItems(workspace)];
}

/** Variables that a function has for itself: from Explorer on, in a program with blocks of its own. */
function localItems(workspace: Blockly.WorkspaceSvg): Items {
  const isOffered = preferences.peek().stage !== "starter" && definitionsIn(workspace).length > 0;
  return isOffered ? [block("lb_set_local", { inputs: { VALUE: ZERO } })] : [];
}

/** The program's own blocks with the values that their inputs begin with; a new one is made in a dialog. */
function procedureItems(workspace: Blockly.WorkspaceSvg): Items {
  const make = button(MAKE_BLOCK, `+ ${t("page-make-button")}`, "lbMake");
  const definitions = definitionsIn(workspace);
  if (!definitions.length) return [make, label(t("page-make-none"), "lbAdvice")];
  const calls = definitions.flatMap(callsOf);
  return [make, label(t("page-make-here"), "lbHeading"), ...calls, block("lb_return", {})];
}

// For Blockly a function with a return inside its body has no result; its calls may still be values.
function callsOf(definition: Blockly.Block): Items {
  const own = ownBlockOf(definition);
  const always = definition.type === "procedures_defreturn";
  const shapes = always ? [true] : [false, ...(answers(definition) ? [true] : [])];
  return shapes.map((isValue) => {
    const state = callState(own, isValue);
    return block(state.type, state);
  });
}

function label(text: string, look: string): Item {
  return { kind: "label", text, "web-class": look } as Item;
}

function answers(definition: Blockly.Block): boolean {
  return definition
    .getDescendants(false)
    .some((inner) => inner.type === "lb_return" && inner.getInputTargetBlock("VALUE") !== null);
}

function askForWhen(workspace: Blockly.WorkspaceSvg): void {
  const target = workspace.targetWorkspace ?? workspace;
  const wish = freeWhenName(target, t("page-blocks-when-name"));
  Blockly.dialog.prompt(t("page-blocks-when-prompt"), wish, (answer) => {
    const name = answer?.trim();
    if (name) addWhen(target, freeWhenName(target, name));
  });
}

function addWhen(workspace: Blockly.WorkspaceSvg, name: string): void {
  const view = workspace.getMetricsManager().getViewMetrics(true);
  const state = { type: "lb_when", fields: { NAME: name }, x: view.left + 40, y: view.top + 40 };
  const block = Blockly.serialization.blocks.append(state, workspace) as Blockly.BlockSvg;
  block.bumpNeighbours();
  Blockly.getFocusManager().focusNode(block);
}
