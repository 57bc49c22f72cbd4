/** What every part of the page is given. */

import type { ReadonlySignal } from "@preact/signals";

import type { Connection } from "./connection";
import type { Problem } from "./messages";
import type { Program } from "./program";
import type { Running } from "./running";

export interface Context {
  readonly connection: Connection;
  readonly program: Program;
  readonly running: Running;
  /** Where the last run ended by an error: a problem for each view. */
  readonly runError: ReadonlySignal<readonly Problem[]>;
  /** Shows a statement in every view: the block's id. */
  reveal(block: string): void;
}
