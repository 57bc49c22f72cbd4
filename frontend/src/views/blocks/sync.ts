/** Shows a workspace by changing only the blocks that differ. */

import * as Blockly from "blockly/core";

import type { Block, Workspace } from "../../protocol/messages";
import { addShadows, build, differsInShape, update } from "./build";
import type { Link, Node } from "./flat";
import { index, shadowLinks } from "./flat";
import type { Covered } from "./places";
import { bottomOf, covered, makeRoom, moveTo, placeBelow } from "./places";
import { readOwn, readWorkspace } from "./read";
import { isPlaced, type Stack, slices } from "./slices";
import { removeVariables, setVariables } from "./variables";

type Svg = Blockly.BlockSvg;
const NOTHING: Workspace = { stacks: [], variables: [] };
/** The ms after which the page may react to the user again while stacks are added. */
const SLICE = 50;

/** Keeps Blockly's workspace and the flat one equal, in both directions. */
export class Sync {
  /** The workspace shown last; Blockly's version of it may differ in spelling. */
  private shown = NOTHING;
  /** The same workspace with the stacks that are still to be added. */
  private wanted = NOTHING;
  private later: readonly Stack[] = [];
  /** The area of each stack when it was last shown or read. */
  private covered = new Map<string, Blockly.utils.Rect>();

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
    if (this.isLoading) return this.wanted;
    if (this.workspace.isDragging()) return this.shown;
    Blockly.renderManagement.triggerQueuedRenders(this.workspace);
    this.silently(() => makeRoom(this.workspace, this.covered));
    this.covered = covered(this.workspace);
    this.shown = this.wanted = readWorkspace(this.workspace, this.order());
    return this.shown;
  }

  /** Show a workspace, of a large one only a part: `addNext` adds the rest. Return whether a block changes. */
  show(wanted: Workspace): boolean {
    if (wanted === this.wanted) return false;
    const before = index(this.shown);
    const { now, later } = slices(before, wanted);
    this.wanted = wanted;
    this.later = later;
    this.shown = later.length ? now : wanted;
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
    this.shown = this.isLoading ? { ...this.shown, stacks: [...this.shown.stacks, stack!] } : this.wanted;
    change.add();
    const first = this.workspace.getBlockById(stack![0]!.id)!;
    this.covered.set(first.id, first.getBoundingRectangle());
    return first;
  }

  private order(): string[] {
    return this.shown.stacks.map((stack) => stack[0]!.id);
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
    return !!node && !differsInShape(this.shownOwn(block), node.block);
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
    this.touched = update(block, own, node.block) || this.touched;
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
    if (unplaced.size) {
      const others = this.workspace.getTopBlocks(false).filter((block) => !unplaced.has(block));
      placeBelow(bottomOf(others.map((block) => block.getBoundingRectangle())), [...unplaced]);
    }
    if (this.touched) makeRoom(this.workspace, this.before);
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
