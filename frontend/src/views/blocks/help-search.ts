/** The blocks for the search of the help: without a program, and on every page. */

import * as Blockly from "blockly/core";
import { DEFINITIONS } from "../../model/own-blocks";
import { nameOf } from "../../model/shown-blocks";
import { plain } from "../../ui/plain";
import { learnPalette } from "./drawing";
import { STYLES } from "./groups";
import { Explanation } from "./help";
import type { Item } from "./offers";
import { prepare } from "./prepare";
import { counting, SearchIndex } from "./search-index";

type State = Blockly.serialization.blocks.State;

/** A block that the search has found. */
export interface FoundBlock {
  /** Its sentence. */
  readonly title: string;
  /** The icon of its group. */
  readonly group: string;
  readonly item: Item;
}

/** The blocks of groups that depend on the program. */
const CHANGING: readonly Item[] = ["lb_when", ...DEFINITIONS].map((type) => {
  return { kind: "block", type };
});

export class BlockSearch {
  private readonly undrawn = new Blockly.Workspace();
  private readonly index: SearchIndex;

  private constructor(blocks: readonly Item[]) {
    const all = [...blocks, ...counting(), ...CHANGING];
    this.index = new SearchIndex(all, () => all);
  }

  static async load(language: string): Promise<BlockSearch> {
    prepare();
    const { toolbox } = await learnPalette(language);
    return new BlockSearch(toolbox.contents.flatMap(({ contents = [] }) => contents));
  }

  /** The blocks with these words, those that others call so, or else the most similar ones: as in the palette. */
  find(words: string): readonly FoundBlock[] {
    const matching = this.index.matching(words);
    const foreign = this.index.foreign(words).flatMap(({ blocks }) => blocks);
    const found = new Set([...matching, ...foreign]);
    const near = found.size ? [] : this.index.similar(words).flatMap(({ blocks }) => blocks);
    const items = [...found, ...near];
    const names = new Set(items.map(nameOf));
    // Of two blocks that do the same, one is listed.
    const listed = items.filter(({ like }) => !like || !names.has(like)).map((item) => this.described(item));
    const begins = ({ title }: FoundBlock) => (plain(title).startsWith(plain(words)) ? 0 : 1);
    return listed.sort((one, other) => begins(one) - begins(other));
  }

  /** The help on a block. */
  explain(item: Item, open: (program: string) => void): Explanation {
    const block = this.made(item);
    const explanation = new Explanation(block, open);
    block.dispose();
    return explanation;
  }

  private described(item: Item): FoundBlock {
    const block = this.made(item);
    const found = { title: block.toString(undefined, "…"), group: STYLES[block.getStyleName()] ?? "my_blocks", item };
    block.dispose();
    return found;
  }

  private made(item: Item): Blockly.Block {
    return Blockly.serialization.blocks.append(item as unknown as State, this.undrawn);
  }
}
