/** Changes of blocks as the server has them. */

import type { Block } from "../protocol/messages";

/** Blocks with a change of each block in them, a block after those inside it. */
export function changedBlocks(blocks: readonly Block[], change: (block: Block) => Block): Block[] {
  return blocks.map((block) => {
    const inputs = Object.entries(block.inputs ?? {}).map(([name, input]) => [
      name,
      {
        ...input,
        ...(input.block ? { block: changedBlocks([input.block], change)[0] } : {}),
        ...(input.stack ? { stack: changedBlocks(input.stack, change) } : {}),
      },
    ]);
    return change(block.inputs ? { ...block, inputs: Object.fromEntries(inputs) } : block);
  });
}
