/**
 * What is changed in Blockly itself: private members, and methods that are replaced for all workspaces.
 *
 * Each entry says what it patches, why, and what a later version must have before it can go. All are written for Blockly
 * 13.3 and its plugins 13.2: go through them when one of these versions changes.
 */

import * as Blockly from "blockly/core";

type Block = Blockly.BlockSvg;
type Act = (...args: unknown[]) => void;

/** Private members of a Blockly gesture. */
interface Gesture {
  readonly flyout: Blockly.IFlyout | null;
  readonly targetBlock: Block | null;
  startIcon: Blockly.IIcon | null;
  doBlockClick(): void;
  setStartField(field: Blockly.Field): void;
}

/** Private members of a Blockly connection: its highlight element has a role. */
interface Lit {
  getSourceBlock(): Block;
  setAriaRole(element: Element): void;
}

/** An input, which Blockly reads to a screen reader by a private method. */
export interface Labelled extends Blockly.Input {
  getLabel(verbosity?: Blockly.utils.aria.Verbosity, withValue?: boolean): string;
}

const block = Blockly.BlockSvg.prototype;
const gesture = Blockly.Gesture.prototype as unknown as Gesture;

/**
 * Patches `BlockSvg.initSvg`: calls a function with each block before it is drawn first, so that fields can be added.
 *
 * Can go with an event or extension for every type of block.
 */
export function beforeDrawing(act: (block: Block) => void): void {
  const { initSvg } = block;
  block.initSvg = function (this: Block) {
    act(this);
    initSvg.call(this);
  };
}

/**
 * Patches `BlockSvg.queueRender`: Blockly removes only drawn blocks from its queue, and disposed blocks are never drawn.
 * Without this every removed block stays in memory and is visited at each rendering.
 *
 * Can go when disposing a block removes it from the queue.
 */
export function forgetDisposed(): void {
  const { queueRender } = block;
  block.queueRender = function (this: Block) {
    return this.isDeadOrDying() ? Promise.resolve() : queueRender.call(this);
  };
}

/**
 * Patches `BlockSvg.bumpNeighbours` and `scheduleSnapAndBump`: after each rendering Blockly compares every block with its
 * neighbours, up to the top of both stacks: 0.3 s with 5,000 blocks. `places.ts` places stacks instead; a block that was
 * dropped beside one that it does not fit is still moved away.
 *
 * Can go when bumping is limited to what was dropped, or can be turned off.
 */
export function bumpOnlyWhatIsDropped(): void {
  const { bumpNeighbours } = block;
  block.bumpNeighbours = () => {};
  block.scheduleSnapAndBump = function (this: Block) {
    this.snapToGrid();
    bumpNeighbours.call(this);
  };
}

/**
 * Patches `RenderedConnection.highlight` and the internal `BlockSvg.moveSvgRootToFront`: Blockly brings a focused block, or
 * a highlighted connection, to the front only in the next frame, by moving everything beside it behind it. What has
 * received the focus meanwhile is then moved in the DOM and loses it, and the keyboard stops working: this happened when
 * two keys were pressed within a frame.
 *
 * Can go when Blockly moves the focused block itself, or returns the focus.
 */
export function keepFocus(): void {
  keepFocusAfter(Blockly.RenderedConnection.prototype, "highlight");
  keepFocusAfter(block as unknown as { moveSvgRootToFront: Act }, "moveSvgRootToFront");
}

/** Return the focus after the next frame's part of a method. */
function keepFocusAfter<Name extends string>(prototype: Record<Name, Act>, name: Name): void {
  const method = prototype[name];
  prototype[name] = function (this: unknown, ...args) {
    let focused: Element | null = null;
    requestAnimationFrame(() => (focused = document.activeElement));
    method.apply(this, args);
    requestAnimationFrame(() => focusAgain(focused));
  };
}

function focusAgain(element: Element | null): void {
  const lost = element !== document.activeElement && element?.isConnected;
  if (lost) (element as HTMLElement | SVGElement).focus({ preventScroll: true });
}

/**
 * Patches the private `Gesture.setStartField`: the field of a block that consists of one field, such as a variable, takes
 * every click, so that its warning could not be read. The icon is inside the block, so it has received the click first.
 *
 * Can go when icons come before such fields.
 */
export function preferIcons(): void {
  const { setStartField } = gesture;
  gesture.setStartField = function (this: Gesture, field) {
    if (!this.startIcon) setStartField.call(this, field);
  };
}

/**
 * Patches the private `Gesture.doBlockClick`: a click in a palette that closes itself calls a function, instead of putting
 * the block on top of the program.
 *
 * Can go with an event for a click in a flyout whose default can be prevented.
 */
export function onPaletteClick(act: (block: Block, workspace: Blockly.WorkspaceSvg) => void): void {
  const { doBlockClick } = gesture;
  gesture.doBlockClick = function (this: Gesture) {
    const { flyout, targetBlock } = this;
    if (!flyout?.autoClose || !targetBlock) return doBlockClick.call(this);
    if (flyout.targetWorkspace) act(targetBlock, flyout.targetWorkspace);
  };
}

/**
 * Patches the private `RenderedConnection.setAriaRole`: Blockly gives each connection of a palette block a role that is
 * invalid in a list.
 *
 * Can go when blocks in a flyout have no roles inside.
 */
export function leaveOutRoles(): void {
  const connection = Blockly.RenderedConnection.prototype as unknown as Lit;
  const { setAriaRole } = connection;
  connection.setAriaRole = function (this: Lit, element) {
    if (this.getSourceBlock().isInFlyout) element.removeAttribute("role");
    else setAriaRole.call(this, element);
  };
}

/**
 * Patches the private `Input.getLabel` and `BlockSvg.getAriaLabel`: the words of an input, and what they become while a
 * whole block is read, as Blockly would pause after each value.
 *
 * Can go when the label of a block can be composed.
 */
export function labelInputs(
  wordsOf: (input: Labelled, verbosity: Blockly.utils.aria.Verbosity | undefined, withValue: boolean) => string,
  seams: { mark(words: string): string; join(label: string): string },
): void {
  let wholeBlock = false;
  const input = Blockly.Input.prototype as Labelled;
  input.getLabel = function (this: Labelled, verbosity, withValue = true) {
    const words = this.isVisible() ? wordsOf(this, verbosity, withValue) : "";
    return wholeBlock && words ? seams.mark(words) : words;
  };
  const { getAriaLabel } = block;
  block.getAriaLabel = function (this: Block, verbosity) {
    wholeBlock = true;
    const label = getAriaLabel.call(this, verbosity);
    wholeBlock = false;
    return seams.join(label);
  };
}

/**
 * Patches `Field.showEditor`: calls a function when a field has opened its editor, to which Blockly gives no name.
 *
 * Can go when Blockly names its editors.
 */
export function afterEditorOpens(act: (field: Blockly.Field) => void): void {
  const field = Blockly.Field.prototype;
  const { showEditor } = field;
  field.showEditor = function (this: Blockly.Field, event) {
    showEditor.call(this, event);
    act(this);
  };
}

/**
 * Patches `MenuItem.createDom`: Blockly says of every entry of a menu whether it is selected, which only choices in a list
 * can be.
 *
 * Can go when only options have `aria-selected`.
 */
export function leaveOutSelection(): void {
  const item = Blockly.MenuItem.prototype;
  const { createDom } = item;
  item.createDom = function () {
    const dom = createDom.call(this);
    if (dom.role === "menuitem") dom.removeAttribute("aria-selected");
    return dom;
  };
}

/**
 * Patches the private `BlockSvg.recomputeAriaContext`: a block that consists of one field is read by that field, but Blockly
 * leaves the label that its outline had before, without a role. This removes it.
 *
 * Can go when Blockly removes it.
 */
export function removeOutlineLabels(): void {
  const { recomputeAriaContext } = block as unknown as { recomputeAriaContext(this: Block): void };
  Object.assign(block, {
    recomputeAriaContext(this: Block) {
      recomputeAriaContext.call(this);
      if (!this.getFullBlockField()) return;
      for (const name of ["aria-label", "aria-roledescription"]) this.pathObject.svgPath.removeAttribute(name);
    },
  });
}

/**
 * Hides the canvas with which Blockly measures texts, which a screen reader would find outside of any region.
 *
 * Can go when Blockly hides it.
 */
export function hideRuler(): void {
  const text = Blockly.utils.dom.createSvgElement(Blockly.utils.Svg.TEXT, {}) as SVGTextElement;
  Blockly.utils.dom.getFastTextWidthWithSizeString(text, "11pt", "600", "sans-serif");
  document.querySelector(".blocklyComputeCanvas")?.setAttribute("aria-hidden", "true");
}

/** What the search plugin registers, as the class that it extends: its own members are private. */
export function searchPlugin(kind: string): typeof Blockly.ToolboxCategory {
  const { TOOLBOX_ITEM } = Blockly.registry.Type;
  return Blockly.registry.getClass(TOOLBOX_ITEM, kind) as unknown as typeof Blockly.ToolboxCategory;
}

/** What is typed in the search plugin's field, which is private. */
export function searchedIn(tab: Blockly.ToolboxCategory): string {
  return (tab as unknown as { readonly searchField?: HTMLInputElement }).searchField?.value.trim() ?? "";
}

/** A tab as what can have the focus: the types of Blockly's items leave it out. */
export function focusable(item: Blockly.IToolboxItem): Blockly.IFocusableNode {
  return item as unknown as Blockly.IFocusableNode;
}

/** What has the focus as a tab, if it is one. */
export function asTab(node: Blockly.IFocusableNode | null): Blockly.IToolboxItem | null {
  return node as unknown as Blockly.IToolboxItem | null;
}

/** Blockly's codes of keys by name: its type is that of an enumeration without numbers. */
export const KEYS = Blockly.utils.KeyCodes as unknown as Readonly<Record<string, number>>;
