/** A preview of a custom block, drawn by Blockly. */

import type * as Blockly from "blockly/core";

import type { CustomBlockPreview } from "../../protocol/messages";
import { BlockPicture } from "../../views/blocks/block-picture";
import type { Definition } from "../../views/blocks/fields";
import { defineBlocks } from "../../views/blocks/palette";

/** Keeps previews apart from the program's blocks of that type. */
const PREVIEW = "lb_preview_";

export class Preview extends BlockPicture {
  /** Define the block as it is now, and draw it. */
  showNow(preview: CustomBlockPreview | null): void {
    if (!preview) return this.show(null);
    const type = PREVIEW + preview.name;
    defineBlocks([{ ...preview.definition, type } as Definition]);
    this.show({ ...preview.block, type } as Blockly.serialization.blocks.State);
  }
}
