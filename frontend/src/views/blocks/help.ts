/** Help on a block, beside the program: what it does, its values, and an example to insert. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { isStoodIn } from "../../model/robots";
import { icon } from "../../ui/icons";
import type { Island } from "../../ui/island";
import "./help.css";
import { actionsOf, type OfferedRobot } from "./actions";
import { blockHelp } from "./block-help";
import { type Parameter, parametersOf } from "./fields/allowed";
import { STYLES } from "./groups";
import { button } from "./help-button";
import type { Item } from "./offers";
import { otherNames } from "./other-names";
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
  const actions = workspace.isReadOnly() ? undefined : actionsOf(workspace);
  const explanation = new Explanation(block, (program) => actions?.openExample(program));
  const close = () => {
    explanation.destroy();
    panel.remove();
    if (!block.isDisposed()) Blockly.getFocusManager().focusNode(block);
  };
  panel.append(headOf(block, close), explanation.dom, ...insertOf(block, workspace));
  panel.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key === "Escape") close();
  });
  return panel;
}

/** What a block does: as a sentence, in words, and in a moving picture of its example. */
export class Explanation implements Island {
  readonly dom = document.createElement("div");
  private readonly sentence = place("lbSentence");
  private readonly picture = place("lbExample");
  private readonly pictures: (Island & { resize(): void })[] = [];
  private isGone = false;

  constructor(
    block: Blockly.Block,
    /** Opens the Block-Text of the example as a project. */
    private readonly open: (program: string) => void,
  ) {
    this.dom.className = "lbExplanation";
    this.dom.append(
      this.sentence,
      paragraph(block.getTooltip()),
      ...elsewhere(block.type),
      this.picture,
      ...robotOf(block),
      ...valuesOf(block),
      ...textsOf(block),
    );
    void this.draw(stateOf(block), nameOf(stateOf(block)), block.toString(undefined, "…"));
  }

  destroy(): void {
    this.isGone = true;
    for (const picture of this.pictures) picture.destroy();
    this.dom.remove();
  }

  resize(): void {
    for (const picture of this.pictures) picture.resize();
  }

  private async draw(state: State, name: string, text: string): Promise<void> {
    const { Drawing } = await import("./drawing");
    if (this.isGone) return;
    this.add(this.sentence, new Drawing(state, text));
    const help = await blockHelp(name);
    if (!help || this.isGone) return;
    const { MovingPicture } = await import("./moving-picture");
    if (this.isGone) return;
    this.picture.append(heading("page-help-example"));
    this.add(this.picture, new MovingPicture(help));
    this.picture.append(button("examples", t("page-help-open-example"), () => this.open(help.program)));
  }

  private add(host: HTMLElement, picture: Island & { resize(): void }): void {
    this.pictures.push(picture);
    host.append(picture.dom);
    picture.resize();
  }
}

/** The block alone, without those inside and below it. */
function stateOf(block: Blockly.Block): State {
  const state = Blockly.serialization.blocks.save(block, { addNextBlocks: false }) as State;
  for (const { name, type } of block.inputList)
    if (type === Blockly.inputs.inputTypes.STATEMENT) delete state.inputs?.[name];
  const { x: _x, y: _y, id: _id, ...alone } = state;
  return alone;
}

/** The name of a block in block sets, by which the server knows its example. */
function nameOf({ type, extraState }: State): string {
  if (type.startsWith(SKILL)) return `function.${type.slice(SKILL.length)}`;
  const { name, hasElse } = (extraState ?? {}) as { name?: string; hasElse?: boolean };
  if (name && type.startsWith("lb_call")) return `${type}:${name}`;
  return hasElse ? `${type}:else` : type;
}

/** What Scratch and MakeCode call it. */
function elsewhere(type: string): HTMLElement[] {
  const names = otherNames(type, t);
  return names ? [heading("page-help-elsewhere"), paragraph(names)] : [];
}

function place(name: string): HTMLElement {
  return Object.assign(document.createElement("div"), { className: name });
}

function heading(word: string): HTMLElement {
  return Object.assign(document.createElement("h4"), { textContent: t(word) });
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
function robotOf(block: Blockly.Block): HTMLElement[] {
  const actions = actionsOf(block.workspace);
  const { needs = [] } = (actions?.offered(block.type) ?? {}) as Item;
  const robot = actions?.robot();
  if (!robot) return [];
  const words = paletteWords(robot.title);
  const lacking = needs
    .filter((need) => robot.lacks.has(need))
    .map((need) => (isStoodIn(need) ? words.standIn(need) : words.missing(need)));
  return [robot.serving(needs), ...lacking, worksOn(needs, robot)].filter(Boolean).map(paragraph);
}

function worksOn(needs: readonly string[], { all }: OfferedRobot): string {
  const able = all.filter(({ lacks }) => !needs.some((need) => lacks.includes(need)));
  if (able.length === all.length) return t("page-blocks-help-all-robots");
  return able.length ? t("page-blocks-help-robots", { robots: able.map(({ title }) => title).join(", ") }) : "";
}

function valuesOf(block: Blockly.Block): HTMLElement[] {
  const parameters = parametersOf(block.type);
  if (!parameters.length) return [];
  const list = document.createElement("dl");
  for (const parameter of parameters) {
    const name = Object.assign(document.createElement("dt"), { textContent: parameter.label });
    const range = rangeOf(parameter);
    const { kind, unit } = parameter;
    const textContent = unit && kind !== "angle" ? t("page-blocks-help-unit", { range, unit }) : range;
    list.append(name, Object.assign(document.createElement("dd"), { textContent }));
  }
  return [heading("page-blocks-help-values"), list];
}

/** What a parameter accepts, such as "a number from 0 to 100". */
function rangeOf({ kind, field: { min, max, options } = {} }: Parameter): string {
  if (options?.length) return t("page-blocks-help-choice", { choices: options.map(([label]) => label).join(", ") });
  if (min !== undefined && max !== undefined) return t("page-blocks-help-range", { min, max });
  return t(`page-blocks-help-${kind}`);
}

/** The block in both texts, with its current values; only skills are written the same way everywhere. */
function textsOf(block: Blockly.Block): HTMLElement[] {
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
  const add = () => {
    panels.get(workspace)?.remove();
    insert(block, workspace);
  };
  return [button("plus", t("page-blocks-help-insert"), add)];
}

/** Add the block as the palette has it: below the block if it is a statement of the program, else beside it. */
function insert(block: Block, workspace: Blockly.WorkspaceSvg): void {
  Blockly.Events.setGroup(true);
  const example = Blockly.serialization.blocks.append(exampleOf(block), workspace) as Block;
  const below = block.isInFlyout ? null : block.nextConnection;
  if (below && example.previousConnection) below.connect(example.previousConnection);
  else putBeside(example, block, workspace);
  Blockly.Events.setGroup(false);
  Blockly.getFocusManager().focusNode(example);
}

function putBeside(example: Block, block: Block, workspace: Blockly.WorkspaceSvg): void {
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
