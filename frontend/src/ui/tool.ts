/** A command that an island offers to the menus outside it. */

import type { ReadonlySignal } from "@preact/signals";

import type { IconName } from "./icons";

/** One with `pressed` can be switched on and off. */
export interface Tool {
  readonly name: IconName;
  /** The key that does the same while the island has the focus. */
  readonly key: string;
  readonly pressed?: ReadonlySignal<boolean>;
  readonly enabled?: ReadonlySignal<boolean>;
  act(): void;
}
