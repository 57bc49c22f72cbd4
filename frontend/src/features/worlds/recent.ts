/** The worlds that the user chose last. */

import { prefer, preferences } from "../../model/preferences";
import type { WorldChoice } from "../../protocol/messages";

/** How many are offered where there is no room for all. */
export const FEW = 4;
/** What is offered to a user who has not chosen as many. */
const USUAL = ["square", "obstacles", "line", "empty"];

/** Remember that a world was chosen. */
export function remember(name: string): void {
  const { recentWorlds } = preferences.value;
  if (recentWorlds[0] === name) return;
  prefer({ recentWorlds: [name, ...recentWorlds.filter((one) => one !== name)].slice(0, FEW) });
}

/** A few worlds: the one in use, those chosen last, and usual ones. */
export function few(worlds: readonly WorldChoice[], used: string): readonly WorldChoice[] {
  const names = new Set([used, ...preferences.value.recentWorlds, ...USUAL]);
  return [...names].flatMap((name) => worlds.find((one) => one.name === name) ?? []).slice(0, FEW);
}
