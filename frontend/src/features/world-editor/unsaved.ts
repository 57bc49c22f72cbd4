/** The unsaved edit of a world, kept by the browser while its tab is open. */

import type { WorldValues } from "../../views/world/scenery/description";

const KEY = "learnblock.world";

interface Unsaved {
  readonly name: string;
  readonly world: WorldValues;
}

/** The unsaved edit of a world; null if there is none. */
export function unsaved(name: string): WorldValues | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEY) ?? "null") as Unsaved | null;
    return kept?.name === name ? kept.world : null;
  } catch {
    // Storage is disabled or contains another program's value: there is nothing to restore.
    return null;
  }
}

export function keep(name: string, world: WorldValues): void {
  sessionStorage.setItem(KEY, JSON.stringify({ name, world } satisfies Unsaved));
}

export function drop(): void {
  sessionStorage.removeItem(KEY);
}
