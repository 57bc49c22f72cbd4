/** Shows a workspace by changing only the blocks that differ. */

import * as Blockly from "blockly/core";

import type { Block, Workspace } from "../../protocol/messages";
import { addShadows, build, differsInShape, update } from "./build";
import type { Link, Node } from "./flat";
import { index, shadowLinks } from "./flat";
import { blocksIn, blocksOf, fold, hiddenIn, REST, type Rest, restOf, unfold } from "./folds";
import { COMMENT, isPart } from "./loose";
import type { Covered } from "./places";
import {
  bottomOf,
  covered,
  keepOrder,
  makeRoom,
  moveTo,
  placeBelow,
  placeInOrder,
  separate,
  withMainAsDrawn,
} from "./places";
import { readOwn, readWorkspace } from "./read";
import { copied } from "./rest-block";
import { isPlaced, type Stack, slices } from "./slices";
import { removeVariables, setVariables } from "./variables";

type Svg = Blockly.BlockSvg;
const NOTHING: Workspace = { stacks: [], variables: [] };
const MAIN = "lb_main";
/** The ms after which the page may react to the user again while stacks are added. */
const SLICE = 30;
type IsFar = (block: Svg) => boolean;

/** Keeps Blockly's workspace and the flat one equal, in both directions. */
export class Sync {
  /** What is drawn of the workspace shown last; Blockly's version of it may differ in spelling. */
  private shown = NOTHING;
  /** The whole workspace, with the stacks that are still to be added. */
  private wanted = NOTHING;
  private later: readonly Stack[] = [];
  /** The area of each stack when it was last shown or read. */
  private covered = new Map<string, Blockly.utils.Rect>();
  /** The placeholder of each hidden block, by their ids; null until it is needed. */
  private hidden: Map<string, string> | null = null;
  /** The blocks that copied placeholders hide, by the ids of the copies. */
  private readonly copies = new Map<string, Block[]>();

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly checker: { lenient: boolean },
  ) {}

  /** Whether stacks are still to be added. */
  get isLoading(): boolean {
    return this.later.length > 0;
  }

  /** The workspace after the user's edits; during a drag, the state before it. */
  read(): Workspace {
    if (this.workspace.isDragging()) return this.wanted;
    Blockly.renderManagement.triggerQueuedRenders(this.workspace);
    this.silently(() => makeRoom(this.workspace, this.covered));
    const before = this.covered;
    this.covered = covered(this.workspace);
    const read = readWorkspace(this.workspace);
    this.shown = this.isPartial ? { ...read, stacks: this.inPlace(read.stacks, before) } : read;
    this.wanted = this.whole();
    this.hidden = null;
    return this.wanted;
  }

  /** The id of the placeholder that hides a block; null for a block that is drawn. */
  placeholderOf(id: string): string | null {
    this.hidden ??= hiddenIn(this.shown);
    return this.hidden.get(id) ?? null;
  }

  /** All blocks that are not drawn, except those of stacks that are still to be added. */
  hiddenBlocks(): Block[] {
    const rests = [...blocksIn(this.shown.stacks.flat())].map(restOf).filter((rest) => rest !== null);
    return rests.flatMap((rest) => [...blocksIn(blocksOf(rest))]);
  }

  get variables(): Workspace["variables"] {
    return this.wanted.variables;
  }

  /** Draw the pieces with these blocks, and no longer those that are all far away. */
  draw(blocks: readonly string[], isFar: IsFar): void {
    if (this.workspace.isDragging()) return;
    // The user may have edited something that is not sent yet.
    this.showNow(this.read(), new Set(blocks), isFar);
  }

  /** Show a workspace, of a large one only a part: `addNext` adds the rest. Return whether a block changes. */
  show(wanted: Workspace): boolean {
    return wanted !== this.wanted && this.showNow(wanted, new Set(), () => false);
  }

  /** What is drawn stays drawn. */
  private showNow(wanted: Workspace, asked: ReadonlySet<string>, isFar: IsFar): boolean {
    const before = index(this.shown);
    const isDrawn = (blocks: readonly Block[], folded: boolean) => {
      const known = blocks.filter(({ id }) => before.has(id)).map(({ id }) => this.workspace.getBlockById(id));
      return known.length > 0 && (folded || !known.every((block) => block && isFar(block)));
    };
    const part = fold(wanted, (blocks, folded) => blocks.some(({ id }) => asked.has(id)) || isDrawn(blocks, folded));
    const { now, later } = slices(before, part);
    this.wanted = wanted;
    this.later = later;
    this.shown = now;
    this.hidden = null;
    const change = new Change(this.workspace, before, now, covered(this.workspace));
    const touched = this.silently(() => change.apply());
    this.covered = covered(this.workspace);
    return touched || this.isLoading;
  }

  /** Add the next stacks of a large workspace, as many as a short time allows; return their first blocks. */
  addNext(): Svg[] {
    const end = performance.now() + SLICE;
    const added: Svg[] = [];
    this.silently(() =>
      sortOnce(this.workspace, () => {
        while (this.isLoading && performance.now() < end) added.push(this.add());
      }),
    );
    return added;
  }

  private add(): Svg {
    const [stack, ...later] = this.later;
    const change = new Change(this.workspace, new Map(), { ...NOTHING, stacks: [stack!] }, this.covered);
    this.later = later;
    this.shown = { ...this.shown, stacks: [...this.shown.stacks, stack!] };
    this.hidden = null;
    change.add();
    const first = this.workspace.getBlockById(stack![0]!.id)!;
    this.covered.set(first.id, first.getBoundingRectangle());
    return first;
  }

  private get isPartial(): boolean {
    return this.isLoading || this.shown.stacks.some((stack) => hasRest(stack));
  }

  /** What is drawn with all the rest; until all stacks are, they keep their order, and new ones are last. */
  private whole(): Workspace {
    if (!this.isPartial) return this.shown;
    const order = new Map(this.wanted.stacks.map(([first], place) => [first!.id, place]));
    const place = ([first]: Stack) => order.get(first!.id) ?? order.size;
    const all = [...this.shown.stacks, ...this.later];
    const drawn = { ...this.shown, stacks: this.isLoading ? all.sort((a, b) => place(a) - place(b)) : all };
    const whole = unfold(drawn, (rest, id) => this.copy(rest, id));
    return { ...whole, variables: [...whole.variables, ...this.lostVariables(whole.variables)] };
  }

  /** Variables that are only used where nothing is drawn stay, even if the user has deleted their other uses. */
  private lostVariables(kept: Workspace["variables"]): Workspace["variables"] {
    const ids = new Set(kept.map(({ id }) => id));
    const lost = this.wanted.variables.filter(({ id }) => !ids.has(id));
    if (!lost.length) return [];
    const used = JSON.stringify([this.hiddenBlocks(), this.later]);
    return lost.filter(({ id }) => used.includes(JSON.stringify(id)));
  }

  private copy(rest: Rest, id: string): Block[] {
    const known = this.copies.get(id) ?? copied(blocksOf(rest));
    this.copies.set(id, known);
    return known;
  }

  /** Stacks that the user has not moved keep their positions, or none: where they are depends on what is drawn. */
  private inPlace(stacks: readonly Stack[], before: Covered): Stack[] {
    const known = new Map(this.wanted.stacks.map(([first]) => [first!.id, first!]));
    return stacks.map((stack) => {
      const [first, ...others] = stack;
      const [was, old, now] = [known.get(first!.id), before.get(first!.id), this.covered.get(first!.id)];
      if (!was || !old || !now || old.top !== now.top || old.left !== now.left) return stack;
      const { x: _x, y: _y, ...own } = first!;
      return [{ ...own, ...(was.x == null ? {} : { x: was.x, y: was.y }) } as Block, ...others];
    });
  }

  // These changes are not edits of the user, and the program is valid even where Blockly would not
  // connect two blocks.
  private silently<T>(change: () => T): T {
    Blockly.Events.disable();
    this.checker.lenient = true;
    this.workspace.setResizesEnabled(false);
    try {
      return change();
    } finally {
      // The whole is measured once, when it is complete.
      this.workspace.setResizesEnabled(!this.isLoading);
      this.checker.lenient = false;
      Blockly.Events.enable();
    }
  }
}

/** One change of the shown workspace. */
class Change {
  private readonly nodes: Map<string, Node>;
  private readonly made: Svg[] = [];
  private touched = false;

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly shown: ReadonlyMap<string, Node>,
    private readonly wanted: Workspace,
    /** The area of each stack before the change. */
    private readonly before: Covered,
  ) {
    this.nodes = index(wanted);
  }

  apply(): boolean {
    const focused = focusedBlock(this.workspace);
    setVariables(this.workspace, this.wanted.variables);
    this.removeOld();
    this.make();
    removeVariables(this.workspace, this.wanted.variables);
    if (this.touched) Blockly.renderManagement.triggerQueuedRenders(this.workspace);
    this.place();
    if (focused) this.focusAgain(focused);
    return this.touched;
  }

  /** Add stacks of new blocks, which leave all others as they are. */
  add(): void {
    this.make();
    Blockly.renderManagement.triggerQueuedRenders(this.workspace);
    const unplaced = this.placeAndListRest();
    placeBelow(bottomOf(this.before.values()), unplaced);
  }

  private make(): void {
    for (const node of this.nodes.values()) this.makeOrUpdate(node);
    this.connect();
    for (const block of this.made) addShadows(block, this.nodes.get(block.id)!.block);
  }

  private removeOld(): void {
    const blocks = this.workspace.getAllBlocks(false).filter((block) => !block.isShadow());
    this.freeIds(blocks);
    const old = new Set(blocks.filter((block) => !this.stays(block)));
    for (const block of blocks) if (!old.has(block)) this.loosen(block, old);
    // From the end: disposing of a block with a chain below it would recurse.
    for (const block of [...old].reverse()) if (!goesWithParent(block, old)) block.dispose(false);
    this.touched ||= old.size > 0;
  }

  // The id of a former shadow may belong to another block now, and Blockly's ids are unique.
  private freeIds(blocks: readonly Svg[]): void {
    const links = shadowLinks(this.nodes);
    for (const block of blocks) {
      for (const { connection, name } of block.inputList) {
        const id = connection && shadowId(connection);
        if (!id || (!links.has(id) && !this.nodes.has(id))) continue;
        if (!sameLink({ parent: block.id, input: name }, links.get(id) ?? null)) connection.setShadowState(null);
      }
    }
  }

  private stays(block: Svg): boolean {
    const node = this.nodes.get(block.id);
    return !!node && (isRest(node.block, block) || !differsInShape(this.shownOwn(block), node.block));
  }

  private shownOwn(block: Svg): Block {
    return this.shown.get(block.id)?.block ?? readOwn(block);
  }

  private loosen(block: Svg, old: ReadonlySet<Svg>): void {
    const parent = block.getParent();
    if (!parent) return;
    if (!old.has(parent) && sameLink(linkOf(block, parent), this.nodes.get(block.id)!.link)) return;
    block.unplug(false);
    this.touched = true;
  }

  private makeOrUpdate(node: Node): void {
    const block = this.workspace.getBlockById(node.block.id);
    if (!block) {
      this.made.push(build(this.workspace, node));
      this.touched = true;
      return;
    }
    const own = this.shownOwn(block);
    if (own === node.block) return;
    if (isRest(node.block, block)) return this.updateRest(block, own, node.block);
    this.touched = update(block, own, node.block) || this.touched;
  }

  private updateRest(block: Svg, shown: Block, wanted: Block): void {
    this.touched ||= restOf(shown)?.count !== restOf(wanted)?.count;
    block.loadExtraState?.(wanted.extraState);
  }

  // Parents first: Blockly visits all children of a block whenever it is connected.
  private connect(): void {
    for (const { block, link } of this.nodes.values()) {
      if (link) this.hang(this.workspace.getBlockById(block.id)!, link);
    }
  }

  private hang(block: Svg, link: Link): void {
    const parent = this.workspace.getBlockById(link.parent)!;
    const connection = link.input ? parent.getInput(link.input)?.connection : parent.nextConnection;
    const own = block.outputConnection ?? block.previousConnection;
    if (!connection || !own || connection.targetConnection === own) return;
    connection.connect(own);
    this.touched = true;
  }

  private place(): void {
    const unplaced = new Set(this.placeAndListRest());
    const ordered = this.ordered(unplaced);
    const last = placeInOrder(ordered, unplaced);
    const among = new Set(ordered.filter((block) => unplaced.has(block) && !last.has(block.id)));
    const below = [...unplaced].filter((block) => !among.has(block));
    if (below.length) {
      const others = this.workspace.getTopBlocks(false).filter((block) => !below.includes(block));
      placeBelow(bottomOf(others.map((block) => block.getBoundingRectangle())), below);
    }
    if (this.touched) makeRoom(this.workspace, this.before);
    keepOrder(ordered, among);
    if (!this.before.size) separate(this.workspace.getTopBlocks(false));
  }

  /** The stacks whose order is that of the program. */
  private ordered(unplaced: ReadonlySet<Svg>): Svg[] {
    const parts = this.wanted.stacks.filter((stack) => isPart(stack.map(({ type }) => type)));
    const blocks = parts.map(([first]) => this.workspace.getBlockById(first!.id)!).filter((block) => block.isEnabled());
    const main = blocks.find(({ type }) => type === MAIN);
    if (!main || unplaced.has(main) || isBeforeComments(blocks, main)) return blocks;
    return withMainAsDrawn(blocks, main, unplaced);
  }

  /** Move stacks to their positions; return the new ones that have none. */
  private placeAndListRest(): Svg[] {
    const unplaced: Svg[] = [];
    for (const stack of this.wanted.stacks) {
      const [first] = stack;
      const block = this.workspace.getBlockById(first!.id)!;
      if (!isPlaced(stack)) {
        if (!this.before.has(block.id)) unplaced.push(block);
      } else if (this.isElsewhere(first!)) {
        moveTo(block, first!.x!, first!.y!);
      }
    }
    return unplaced;
  }

  private isElsewhere(first: Block): boolean {
    const shown = this.shown.get(first.id)?.block;
    return !this.before.has(first.id) || shown?.x !== first.x || shown?.y !== first.y;
  }

  private focusAgain(id: string): void {
    const again = this.made.find((block) => block.id === id);
    if (again) Blockly.getFocusManager().focusNode(again);
  }
}

/** Whether all that follows `main` are comments, which stay there only if it is drawn so. */
function isBeforeComments(stacks: readonly Svg[], main: Svg): boolean {
  const behind = stacks.slice(stacks.indexOf(main) + 1);
  return behind.length > 0 && behind.every(({ type }) => type === COMMENT);
}

/** Whether both are placeholders. */
function isRest(wanted: Block, block: Svg): boolean {
  return wanted.type === REST && block.type === REST;
}

function hasRest(stack: Stack): boolean {
  for (const block of blocksIn(stack)) if (block.type === REST) return true;
  return false;
}

/** The id of the shadow in an input, even if a block covers it. */
function shadowId(connection: Blockly.Connection): string | null {
  const target = connection.targetBlock();
  return target?.isShadow() ? target.id : (connection.getShadowState()?.id ?? null);
}

function goesWithParent(block: Svg, old: ReadonlySet<Svg>): boolean {
  const parent = block.outputConnection && block.getParent();
  return !!parent && old.has(parent);
}

function linkOf(block: Svg, parent: Svg): Link {
  const connection = (block.outputConnection ?? block.previousConnection)?.targetConnection;
  if (connection === parent.nextConnection) return { parent: parent.id, input: "" };
  return { parent: parent.id, input: connection?.getParentInput()?.name ?? "" };
}

function sameLink(one: Link, other: Link | null): boolean {
  return other !== null && one.parent === other.parent && one.input === other.input;
}

// Blockly sorts all connections after each change of a stack.
function sortOnce(workspace: Blockly.WorkspaceSvg, change: () => void): void {
  const lists = workspace.connectionDBList;
  for (const list of lists) list?.beginBulkUpdates();
  try {
    change();
  } finally {
    for (const list of lists) list?.endBulkUpdates();
  }
}

function focusedBlock(workspace: Blockly.WorkspaceSvg): string | null {
  const node = Blockly.getFocusManager().getFocusedNode();
  return node instanceof Blockly.BlockSvg && node.workspace === workspace ? node.id : null;
}
