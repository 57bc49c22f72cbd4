/** The objects that every part of the page can use. */

import type { ReadonlySignal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { BlockSet, CustomBlock, Problem } from "../protocol/messages";
import type { Program } from "./program";
import type { Running } from "./running";

export interface Context {
  readonly connection: Connection;
  readonly program: Program;
  readonly running: Running;
  /** The error of the last run, as a problem in each view. */
  readonly runError: ReadonlySignal<readonly Problem[]>;
  /** The custom blocks; null until the server has sent them. */
  readonly customBlocks: ReadonlySignal<readonly CustomBlock[] | null>;
  /** The set of blocks that the palette shows. */
  readonly shownBlocks: ReadonlySignal<BlockSet>;
  /** The tag dictionary: the number of each name. */
  readonly tagNames: ReadonlySignal<Readonly<Record<string, number>>>;
  /** Shows a statement, given by its block's id, in every view. */
  reveal(block: string): void;
  /** Opens the list of custom blocks. */
  listCustomBlocks(): void;
  /** Opens a custom block at a line of its source, from 1; a new one if the name is empty. */
  editCustomBlock(name: string, line?: number): void;
}
