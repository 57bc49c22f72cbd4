/** The world that was edited and not saved: kept by the browser while its tab is open. */

import type { WorldValues } from "../description";

const KEY = "learnblock.world";

interface Unsaved {
  readonly name: string;
  readonly world: WorldValues;
}

/** What was left of a world; null when nothing was. */
export function unsaved(name: string): WorldValues | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEY) ?? "null") as Unsaved | null;
    return kept?.name === name ? kept.world : null;
  } catch {
    // A browser that keeps nothing, or somebody else's value: there is nothing to go on with.
    return null;
  }
}

export function keep(name: string, world: WorldValues): void {
  sessionStorage.setItem(KEY, JSON.stringify({ name, world } satisfies Unsaved));
}

export function drop(): void {
  sessionStorage.removeItem(KEY);
}
