/** What every part of the page is given. */

import type { Connection } from "./connection";
import type { Program } from "./program";
import type { Running } from "./running";

export interface Context {
  readonly connection: Connection;
  readonly program: Program;
  readonly running: Running;
  /** Shows a statement in every view: the block's id. */
  reveal(block: string): void;
}
