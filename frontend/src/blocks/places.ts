/** Where stacks stand: new ones below the others, and none on another since it has grown. */

import * as Blockly from "blockly/core";

const LEFT = 40;
const GAP = 40;

type Rect = Blockly.utils.Rect;
/** What each stack covered, by the id of its first block. */
export type Covered = ReadonlyMap<string, Rect>;

export function covered(workspace: Blockly.WorkspaceSvg): Covered {
  return new Map(workspace.getTopBlocks(false).map((block) => [block.id, block.getBoundingRectangle()]));
}

/** Put stacks that nobody has placed one below the other, under all that have a place. */
export function placeBelow(workspace: Blockly.WorkspaceSvg, unplaced: readonly Blockly.BlockSvg[]): void {
  const moving = new Set(unplaced);
  const others = workspace.getTopBlocks(false).filter((block) => !moving.has(block));
  let bottom = Math.max(0, ...others.map((block) => block.getBoundingRectangle().bottom));
  for (const block of unplaced) {
    moveTo(block, LEFT, bottom + GAP);
    bottom = block.getBoundingRectangle().bottom;
  }
}

export function moveTo(block: Blockly.BlockSvg, x: number, y: number): void {
  const place = block.getRelativeToSurfaceXY();
  block.moveBy(x - place.x, y - place.y);
}

/** Push down what has come to lie under a stack that has grown. */
export function makeRoom(workspace: Blockly.WorkspaceSvg, before: Covered): void {
  const stacks = workspace.getTopBlocks(false).filter((block) => before.has(block.id));
  stacks.sort((a, b) => before.get(a.id)!.top - before.get(b.id)!.top);
  stacks.forEach((upper, place) => {
    for (const lower of stacks.slice(place + 1)) pushBelow(upper, lower, before);
  });
}

function pushBelow(upper: Blockly.BlockSvg, lower: Blockly.BlockSvg, before: Covered): void {
  const [above, below] = [before.get(upper.id)!, before.get(lower.id)!];
  // Whoever laid one on the other wants it so.
  if (above.intersects(below) || below.top < above.bottom) return;
  const [now, next] = [upper.getBoundingRectangle(), lower.getBoundingRectangle()];
  if (now.intersects(next)) lower.moveBy(0, now.bottom + GAP - next.top);
}
