/** What every part of the page is given. */

import type { ReadonlySignal } from "@preact/signals";

import type { Connection } from "./connection";
import type { BlockSet, OwnBlock, Problem } from "./messages";
import type { Program } from "./program";
import type { Running } from "./running";

export interface Context {
  readonly connection: Connection;
  readonly program: Program;
  readonly running: Running;
  /** Where the last run ended by an error: a problem for each view. */
  readonly runError: ReadonlySignal<readonly Problem[]>;
  /** The blocks that the user has made; null until the server has told. */
  readonly ownBlocks: ReadonlySignal<readonly OwnBlock[] | null>;
  /** Which blocks the palette shows. */
  readonly shownBlocks: ReadonlySignal<BlockSet>;
  /** The dictionary of tags: the number of each name. */
  readonly tagNames: ReadonlySignal<Readonly<Record<string, number>>>;
  /** Shows a statement in every view: the block's id. */
  reveal(block: string): void;
  /** Opens the list of the user's own blocks. */
  listOwnBlocks(): void;
  /** Opens one of them, at a line of its source from 1; a new one where the name is empty. */
  editOwnBlock(name: string, line?: number): void;
}
