/** The blocks that wait to be drawn: those that are going do not. */

import * as Blockly from "blockly/core";

/**
 * Keeps blocks that are being disposed of out of Blockly's queue.
 *
 * It takes out only what it has drawn, and what is disposed of never is: without this every block that
 * was ever removed stays in memory, and is gone through whenever something is drawn.
 */
export function forgetDisposed(): void {
  const { queueRender } = Blockly.BlockSvg.prototype;
  Blockly.BlockSvg.prototype.queueRender = function (this: Blockly.BlockSvg) {
    return this.isDeadOrDying() ? Promise.resolve() : queueRender.call(this);
  };
}
