/** What Blockly does whenever something is drawn, without what costs a large program dear. */

import * as Blockly from "blockly/core";

const block = Blockly.BlockSvg.prototype;

/** To be called once, before the first workspace is made. */
export function tuneRendering(): void {
  forgetDisposed();
  bumpOnlyWhatIsDropped();
}

// It takes out of its queue only what it has drawn, and what is disposed of never is: without this
// every block that was ever removed stays in memory, and is gone through at each drawing.
function forgetDisposed(): void {
  const { queueRender } = block;
  block.queueRender = function (this: Blockly.BlockSvg) {
    return this.isDeadOrDying() ? Promise.resolve() : queueRender.call(this);
  };
}

// After each drawing it compares every block with all that are near, climbing to the top of both:
// a third of a second at 5,000 blocks. Where stacks stand is our business (`places.ts`); what was
// dropped beside something that it does not fit is still moved away from it.
function bumpOnlyWhatIsDropped(): void {
  const { bumpNeighbours } = block;
  block.bumpNeighbours = () => {};
  block.scheduleSnapAndBump = function (this: Blockly.BlockSvg) {
    this.snapToGrid();
    bumpNeighbours.call(this);
  };
}
