/** Hides texts and values of blocks far outside the screen, but not their shapes. */

import type * as Blockly from "blockly/core";

/**
 * Limits what the browser paints by the size of the screen, not of the program.
 *
 * A browser creates a layer for each part of each block and visits all of them whenever
 * anything on the page changes, even a text cursor: 0.1 s with 5,000 blocks. A block that
 * is one screen away or more keeps its shape, which can take the focus and has the block's name.
 */
export class Sight {
  private frame = 0;

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  destroy(): void {
    cancelAnimationFrame(this.frame);
  }

  /** Update after a movement, at most once per frame. */
  look(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.mark(this.workspace.getAllBlocks(false));
    });
  }

  /** Update for these blocks only, at once. */
  mark(blocks: readonly Blockly.BlockSvg[]): void {
    const { top, height } = this.workspace.getMetricsManager().getViewMetrics(true);
    for (const block of blocks) {
      if (block.outputConnection) continue;
      const y = topOf(block);
      const far = y > top + 2 * height || y + block.height < top - height;
      block.getSvgRoot().classList.toggle("lbFar", far);
      block.getSvgRoot().classList.toggle("lbNear", !far);
    }
  }
}

// Not `getRelativeToSurfaceXY`, which climbs to the top of the stack.
function topOf(block: Blockly.BlockSvg): number {
  return block.previousConnection?.y ?? block.getRelativeToSurfaceXY().y;
}
