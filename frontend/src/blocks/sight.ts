/** Words and values of blocks that are far out of sight are not painted; their shapes are. */

import * as Blockly from "blockly/core";

/**
 * Keeps what the browser has to paint in proportion to the screen and not to the program.
 *
 * A browser makes a piece of picture of each part of each block, and goes through all of them whenever
 * anything on the page changes, the cursor of a text included: at 5,000 blocks a tenth of a second. What
 * is one screen away or more keeps its shape, which can have the focus and has the block's name.
 */
export class Sight {
  private frame = 0;

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  destroy(): void {
    cancelAnimationFrame(this.frame);
  }

  /** Something has moved: look again, once a frame at most. */
  look(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.mark();
    });
  }

  private mark(): void {
    const { top, height } = this.workspace.getMetricsManager().getViewMetrics(true);
    for (const block of this.workspace.getAllBlocks(false)) {
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
