/** Draws stacks that do not run as inactive. */

import type * as Blockly from "blockly/core";

import { DEFINITIONS } from "../../model/own-blocks";
import { WHENS } from "../../model/whens";

type Svg = Blockly.BlockSvg;

/** The blocks that begin a part of the program, as on the server. */
const HATS = new Set(["lb_main", "lb_start", ...WHENS, ...DEFINITIONS]);
export const COMMENT = "lb_comment";

/** Whether a stack, given by its blocks' types, is a part of the program. */
export function isPart(types: readonly string[]): boolean {
  return HATS.has(types[0] ?? "") || types.every((type) => type === COMMENT);
}

/** Marks the stacks of a workspace. */
export class Loose {
  private marked = new Set<Svg>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  /** Update the marks after blocks have moved. */
  mark(): void {
    const loose = new Set(this.workspace.getTopBlocks(false).filter((block) => !isPart(typesOf(block))));
    for (const block of this.marked) if (!loose.has(block) && !block.isDisposed()) block.removeClass("lbLoose");
    for (const block of loose) block.addClass("lbLoose");
    this.marked = loose;
  }
}

function typesOf(top: Svg): string[] {
  if (top.type !== COMMENT) return [top.type];
  const types: string[] = [];
  for (let block: Svg | null = top; block; block = block.getNextBlock()) types.push(block.type);
  return types;
}
