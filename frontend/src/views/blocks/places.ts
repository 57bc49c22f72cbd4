/** Positions stacks: new ones below the others, and none covered by one that has grown. */

import type * as Blockly from "blockly/core";

import type { Workspace } from "../../protocol/messages";

const LEFT = 40;
/** Between two stacks, in units of the workspace; on a phone there is less room. */
const GAP = 40;
const COMPACT_GAP = 16;

type Rect = Blockly.utils.Rect;
/** The area of each stack, by the id of its first block. */
export type Covered = ReadonlyMap<string, Rect>;

function gapIn({ horizontalLayout }: Blockly.WorkspaceSvg): number {
  return horizontalLayout ? COMPACT_GAP : GAP;
}

export function covered(workspace: Blockly.WorkspaceSvg): Map<string, Rect> {
  return new Map(workspace.getTopBlocks(false).map((block) => [block.id, block.getBoundingRectangle()]));
}

/** The lower end of all areas. */
export function bottomOf(areas: Iterable<Rect>): number {
  let bottom = 0;
  for (const area of areas) bottom = Math.max(bottom, area.bottom);
  return bottom;
}

/** Put stacks without a position below `bottom`, one below the other. */
export function placeBelow(bottom: number, unplaced: readonly Blockly.BlockSvg[]): void {
  let above = bottom;
  for (const block of unplaced) {
    moveTo(block, LEFT, above + gapIn(block.workspace));
    above = block.getBoundingRectangle().bottom;
  }
}

/** A program in which stacks without a position are below `bottom`. */
export function placedBelow(program: Workspace, bottom: number): Workspace {
  const stacks = program.stacks.map(([first, ...others]) =>
    first!.x == null ? [{ ...first!, x: LEFT, y: bottom + GAP }, ...others] : [first!, ...others],
  );
  return { ...program, stacks };
}

/** Stacks as they are drawn: from top to bottom, then from left to right. */
export function inDrawnOrder<Stack extends Blockly.BlockSvg>(stacks: readonly Stack[]): Stack[] {
  return [...stacks].sort(compare);
}

function compare(one: Blockly.BlockSvg, other: Blockly.BlockSvg): number {
  const [a, b] = [one.getRelativeToSurfaceXY(), other.getRelativeToSurfaceXY()];
  return Math.round(a.y) - Math.round(b.y) || Math.round(a.x) - Math.round(b.x);
}

/** Stacks in the order of the program, but `main`, which runs last wherever it is, where it is drawn. */
export function withMainAsDrawn(
  stacks: readonly Blockly.BlockSvg[],
  main: Blockly.BlockSvg,
  unplaced: ReadonlySet<Blockly.BlockSvg>,
): Blockly.BlockSvg[] {
  const others = stacks.filter((one) => one !== main);
  const next = others.findIndex((one) => !unplaced.has(one) && compare(main, one) < 0);
  const place = next < 0 ? others.length : next;
  return [...others.slice(0, place), main, ...others.slice(place)];
}

/** Give each new stack the place of the next one in the order of the program; return those without a next one. */
export function placeInOrder(
  stacks: readonly Blockly.BlockSvg[],
  unplaced: ReadonlySet<Blockly.BlockSvg>,
): Set<string> {
  const last = new Set<string>();
  let next: Blockly.BlockSvg | null = null;
  for (const block of [...stacks].reverse()) {
    const place: Blockly.utils.Coordinate | undefined = next?.getRelativeToSurfaceXY();
    if (unplaced.has(block) && !place) last.add(block.id);
    else {
      if (unplaced.has(block) && place) moveTo(block, place.x, place.y);
      next = block;
    }
  }
  return last;
}

/** Move down stacks that are drawn before one that comes first in the program, and those that they then cover. */
export function keepOrder(stacks: readonly Blockly.BlockSvg[], placed: ReadonlySet<Blockly.BlockSvg>): void {
  const moved = new Set(placed);
  stacks.forEach((lower, place) => {
    const above = stacks.slice(0, place);
    const upper = above.at(-1);
    if (!upper) return;
    const area = lower.getBoundingRectangle();
    const isCovered = above.some((one) => moved.has(one) && one.getBoundingRectangle().intersects(area));
    if (compare(upper, lower) < 0 && !isCovered) return;
    const bottom = bottomOf(above.map((one) => one.getBoundingRectangle()));
    moveTo(lower, lower.getRelativeToSurfaceXY().x, bottom + gapIn(lower.workspace));
    moved.add(lower);
  });
}

export function moveTo(block: Blockly.BlockSvg, x: number, y: number): void {
  const place = block.getRelativeToSurfaceXY();
  block.moveBy(x - place.x, y - place.y);
}

/** Move down stacks that others cover: they were placed where blocks have other sizes, as on a phone. */
export function separate(stacks: readonly Blockly.BlockSvg[]): void {
  const above: Blockly.BlockSvg[] = [];
  for (const lower of inDrawnOrder(stacks)) {
    // One that is pushed may reach one that it did not reach before.
    for (let isPushed = true; isPushed; ) isPushed = above.some((upper) => pushBelow(upper, lower));
    above.push(lower);
  }
}

/** Move down stacks that a grown stack now covers. */
export function makeRoom(workspace: Blockly.WorkspaceSvg, before: Covered): void {
  const stacks = workspace.getTopBlocks(false).filter((block) => before.has(block.id));
  stacks.sort((a, b) => before.get(a.id)!.top - before.get(b.id)!.top);
  const pushed = new Set<Blockly.BlockSvg>();
  stacks.forEach((upper, place) => {
    if (!pushed.has(upper) && !hasGrown(upper, before)) return;
    for (const lower of stacks.slice(place + 1)) {
      if (!wasUnder(lower, upper, before) || (!pushed.has(lower) && hasMoved(lower, before))) continue;
      if (pushBelow(upper, lower)) pushed.add(lower);
    }
  });
}

function hasMoved(block: Blockly.BlockSvg, before: Covered): boolean {
  const [old, now] = [before.get(block.id)!, block.getBoundingRectangle()];
  return now.top !== old.top || now.left !== old.left;
}

function hasGrown(block: Blockly.BlockSvg, before: Covered): boolean {
  return !hasMoved(block, before) && block.getBoundingRectangle().bottom > before.get(block.id)!.bottom;
}

// Stacks that the user put on one another stay there.
function wasUnder(lower: Blockly.BlockSvg, upper: Blockly.BlockSvg, before: Covered): boolean {
  return before.get(lower.id)!.top >= before.get(upper.id)!.bottom;
}

function pushBelow(upper: Blockly.BlockSvg, lower: Blockly.BlockSvg): boolean {
  const [above, below] = [upper.getBoundingRectangle(), lower.getBoundingRectangle()];
  if (!above.intersects(below)) return false;
  lower.moveBy(0, above.bottom + gapIn(lower.workspace) - below.top);
  return true;
}
