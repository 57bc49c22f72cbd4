/** Help on a block, beside the program: what it does, its values, and an example to insert. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { icon } from "../../ui/icons";
import { actionsOf, type OfferedRobot } from "./actions";
import { type Parameter, parametersOf } from "./fields/allowed";
import { STYLES } from "./groups";
import type { Item } from "./offers";
import { groupIcon } from "./palette-group";
import { paletteWords } from "./palette-words";

type Block = Blockly.BlockSvg;
type State = Blockly.serialization.blocks.State;

/** Between a block and its example, in units of the workspace. */
const GAP = 40;

/** The prefix of a skill block's type; the skill's name follows. */
const SKILL = "lb_skill_";
/** What a skill is called on in each text. */
const OBJECTS = { blocktext: "function", python: "robot" } as const;

/** The open panel of each view. */
const panels = new WeakMap<Blockly.WorkspaceSvg, HTMLElement>();

/** Show the help on a block of the program or the palette, in place of any other. */
export function showHelp(block: Block): void {
  const workspace = block.workspace.targetWorkspace ?? block.workspace;
  panels.get(workspace)?.remove();
  const panel = panelOf(block, workspace);
  panels.set(workspace, panel);
  workspace.getInjectionDiv().append(panel);
  panel.focus();
}

function panelOf(block: Block, workspace: Blockly.WorkspaceSvg): HTMLElement {
  const panel = document.createElement("section");
  panel.className = "lbHelp";
  panel.tabIndex = -1;
  panel.setAttribute("role", "dialog");
  panel.ariaLabel = t("page-blocks-help-on", { block: block.toString() });
  const close = () => {
    panel.remove();
    if (!block.isDisposed()) Blockly.getFocusManager().focusNode(block);
  };
  panel.append(
    headOf(block, close),
    paragraph(block.getTooltip()),
    ...robotOf(block),
    ...valuesOf(block),
    ...textsOf(block),
    ...insertOf(block, workspace),
  );
  panel.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key === "Escape") close();
  });
  return panel;
}

function headOf(block: Block, close: () => void): HTMLElement {
  const head = document.createElement("header");
  const title = document.createElement("h3");
  title.textContent = block.toString(undefined, "…");
  const button = document.createElement("button");
  button.type = "button";
  button.className = "lbPin";
  button.ariaLabel = button.title = t("page-blocks-close");
  button.append(icon("close"));
  button.addEventListener("click", close);
  head.append(groupIcon(STYLES[block.getStyleName()] ?? "my_blocks"), title, button);
  return head;
}

function paragraph(text: string): HTMLElement {
  return Object.assign(document.createElement("p"), { textContent: text });
}

/** What serves the block's senses on the chosen robot, or what that robot lacks; and the robots that can do it. */
function robotOf(block: Block): HTMLElement[] {
  const actions = actionsOf(block.workspace);
  const { needs = [] } = (actions?.offered(block.type) ?? {}) as Item;
  const robot = actions?.robot();
  if (!robot) return [];
  const lacking = needs.filter((need) => robot.lacks.has(need)).map(paletteWords(robot.title).missing);
  return [robot.serving(needs), ...lacking, worksOn(needs, robot)].filter(Boolean).map(paragraph);
}

function worksOn(needs: readonly string[], { all }: OfferedRobot): string {
  const able = all.filter(({ lacks }) => !needs.some((need) => lacks.includes(need)));
  if (able.length === all.length) return t("page-blocks-help-all-robots");
  return able.length ? t("page-blocks-help-robots", { robots: able.map(({ title }) => title).join(", ") }) : "";
}

function valuesOf(block: Block): HTMLElement[] {
  const parameters = parametersOf(block.type);
  if (!parameters.length) return [];
  const heading = Object.assign(document.createElement("h4"), { textContent: t("page-blocks-help-values") });
  const list = document.createElement("dl");
  for (const parameter of parameters) {
    const name = Object.assign(document.createElement("dt"), { textContent: parameter.label });
    const range = rangeOf(parameter);
    const { kind, unit } = parameter;
    const textContent = unit && kind !== "angle" ? t("page-blocks-help-unit", { range, unit }) : range;
    list.append(name, Object.assign(document.createElement("dd"), { textContent }));
  }
  return [heading, list];
}

/** What a parameter accepts, such as "a number from 0 to 100". */
function rangeOf({ kind, field: { min, max, options } = {} }: Parameter): string {
  if (options?.length) return t("page-blocks-help-choice", { choices: options.map(([label]) => label).join(", ") });
  if (min !== undefined && max !== undefined) return t("page-blocks-help-range", { min, max });
  return t(`page-blocks-help-${kind}`);
}

/** The block in both texts, with its current values; only skills are written the same way everywhere. */
function textsOf(block: Block): HTMLElement[] {
  if (!block.type.startsWith(SKILL)) return [];
  const values = parametersOf(block.type).map(({ name }) => literalOf(block.getInputTargetBlock(name)));
  const call = `${block.type.slice(SKILL.length)}(${values.join(", ")})`;
  const list = document.createElement("dl");
  list.className = "lbTexts";
  for (const [view, object] of Object.entries(OBJECTS)) {
    const name = Object.assign(document.createElement("dt"), { textContent: t(`page-shell-${view}`) });
    const code = Object.assign(document.createElement("code"), { textContent: `${object}.${call}` });
    const place = document.createElement("dd");
    place.append(code);
    list.append(name, place);
  }
  return [list];
}

/** A value as both texts write it; "…" for one that is calculated. */
function literalOf(value: Blockly.Block | null): string {
  const [number, text, truth] = ["NUM", "TEXT", "BOOL"].map((name) => value?.getFieldValue(name));
  if (number !== null && number !== undefined) return String(number);
  if (truth) return truth === "TRUE" ? "True" : "False";
  return text === null || text === undefined ? "…" : JSON.stringify(text);
}

function insertOf(block: Block, workspace: Blockly.WorkspaceSvg): HTMLElement[] {
  if (workspace.isReadOnly()) return [];
  const button = document.createElement("button");
  button.type = "button";
  button.className = "lbInsert";
  button.append(icon("plus"), t("page-blocks-help-insert"));
  button.addEventListener("click", () => {
    panels.get(workspace)?.remove();
    insert(block, workspace);
  });
  return [button];
}

/** Add the block as the palette has it: below the block if it is a statement of the program, else beside it. */
function insert(block: Block, workspace: Blockly.WorkspaceSvg): void {
  Blockly.Events.setGroup(true);
  const example = Blockly.serialization.blocks.append(exampleOf(block), workspace) as Block;
  const below = block.isInFlyout ? null : block.nextConnection;
  if (below && example.previousConnection) below.connect(example.previousConnection);
  else place(example, block, workspace);
  Blockly.Events.setGroup(false);
  Blockly.getFocusManager().focusNode(example);
}

function place(example: Block, block: Block, workspace: Blockly.WorkspaceSvg): void {
  const view = workspace.getMetricsManager().getViewMetrics(true);
  const at = block.isInFlyout
    ? { x: view.left, y: view.top }
    : { x: block.getBoundingRectangle().right, y: block.getBoundingRectangle().top };
  example.moveTo(new Blockly.utils.Coordinate(at.x + GAP, at.y + GAP));
}

function exampleOf({ type, workspace }: Block): State {
  const offered = actionsOf(workspace)?.offered(type);
  return (offered ?? { type }) as State;
}
