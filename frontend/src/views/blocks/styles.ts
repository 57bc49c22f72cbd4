/** Gives each block the colour of its group in the palette, also Blockly's own blocks and calls. */

import * as Blockly from "blockly/core";

/** Blockly's blocks that are in a different group than usual. */
const STYLES: Readonly<Record<string, string>> = {
  controls_if: "loop_blocks",
  controls_if_if: "loop_blocks",
  controls_if_elseif: "loop_blocks",
  controls_if_else: "loop_blocks",
  math_on_list: "list_blocks",
};

/** The styles of calls, by the name of the function. */
type Calls = Readonly<Record<string, string>>;
let calls: Calls = {};

/** Call it once, before the first block is created. */
export function correctStyles(): void {
  for (const [type, style] of Object.entries(STYLES)) {
    const definition = Blockly.Blocks[type];
    const { init } = definition;
    definition.init = function (this: Blockly.Block) {
      init.call(this);
      this.setStyle(style);
    };
  }
}

export function learnCalls(known: Calls): void {
  calls = known;
}

/** Give a call the colour of the functions like it. */
export function styleCall(block: Blockly.Block, name: string): void {
  const style = Object.hasOwn(calls, name) ? calls[name] : undefined;
  if (style) block.setStyle(style);
}
