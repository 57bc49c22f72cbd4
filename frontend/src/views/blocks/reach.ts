/** Draws the pieces of long lists of statements that are in sight, and forgets those that are far from it. */

import * as Blockly from "blockly/core";

import { countOf, REST } from "./folds";
import { restIn } from "./rest-block";
import type { Sync } from "./sync";

type Svg = Blockly.BlockSvg;

/** More blocks than these slow down the page. */
const MOST = 1200;
/** Screens above and below the screen in which pieces are drawn, and outside of which they may be forgotten. */
const NEAR = 0.5;
const FAR = 2;

interface Range {
  readonly top: number;
  readonly bottom: number;
}

/** A piece, by its first block, and where it is. */
interface Place {
  readonly first: string;
  readonly from: number;
  readonly to: number;
}

export class Reach {
  private frame = 0;

  /** @param drawn is called when blocks have been drawn. */
  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly sync: Sync,
    private readonly drawn: () => void,
  ) {}

  destroy(): void {
    cancelAnimationFrame(this.frame);
  }

  /** Draw what has come into sight, with the next frame. */
  look(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      if (!this.workspace.isDragging() && this.drawNear()) this.look();
    });
  }

  /** Draw the pieces with these blocks; what is on the screen stays where it is. */
  draw(blocks: readonly string[]): void {
    const anchor = this.anchor();
    const isTooMuch = this.workspace.getAllBlocks(false).length > MOST;
    this.sync.draw(blocks, isTooMuch ? (block) => this.isFar(block) : () => false);
    if (anchor) this.keep(anchor);
    this.drawn();
  }

  /** Draw the piece that is nearest to the middle of the screen; return whether there is one near it. */
  private drawNear(): boolean {
    const { top, bottom } = this.range(NEAR);
    const middle = (top + bottom) / 2;
    const distance = ({ from, to }: Place) => Math.max(from - middle, middle - to);
    const rests = this.workspace.getBlocksByType(REST, false) as Svg[];
    const near = rests.flatMap(placesIn).filter(({ from, to }) => from < bottom && to > top);
    const nearest = near.sort((one, other) => distance(one) - distance(other))[0];
    if (nearest) this.draw([nearest.first]);
    return nearest !== undefined;
  }

  private range(screens: number): Range {
    const { top, height } = this.workspace.getMetricsManager().getViewMetrics(true);
    return { top: top - screens * height, bottom: top + (1 + screens) * height };
  }

  private isFar(block: Svg): boolean {
    const { top, bottom } = this.range(FAR);
    const focused = Blockly.getFocusManager().getFocusedNode();
    const isUsed = focused instanceof Blockly.BlockSvg && isIn(focused, block);
    return !isUsed && (topOf(block) > bottom || topOf(block) + block.height < top);
  }

  /** The first statement on the screen, and where it is. */
  private anchor(): { readonly block: Svg; readonly y: number } | null {
    const { top, bottom } = this.range(0);
    let first: Svg | null = null;
    for (const block of this.workspace.getAllBlocks(false)) {
      if (block.outputConnection || block.type === REST) continue;
      const y = topOf(block);
      if (y >= top && y < bottom && (!first || y < topOf(first))) first = block;
    }
    return first && { block: first, y: topOf(first) };
  }

  private keep({ block, y }: { readonly block: Svg; readonly y: number }): void {
    const moved = block.isDisposed() ? 0 : topOf(block) - y;
    const { scrollX, scrollY, scale } = this.workspace;
    if (moved) this.workspace.scroll(scrollX, scrollY - moved * scale);
  }
}

/** Roughly where the pieces that a placeholder hides would be; they are drawn when they come into sight. */
function placesIn(block: Svg): Place[] {
  const rest = restIn(block);
  if (!rest || rest.folded) return [];
  let to = topOf(block);
  return rest.pieces.map((piece) => {
    const from = to;
    to += (countOf(piece) / rest.count) * block.height;
    return { first: piece[0]?.id ?? "", from, to };
  });
}

function topOf(block: Svg): number {
  return block.previousConnection?.y ?? block.getRelativeToSurfaceXY().y;
}

function isIn(block: Svg, outer: Svg): boolean {
  for (let one: Svg | null = block; one; one = one.getSurroundParent()) if (one === outer) return true;
  return false;
}
