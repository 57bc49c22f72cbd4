/** The blocks that a set shows; the server stores sets but does not evaluate them. */

import type { BlockSet } from "../protocol/messages";
import { WHENS } from "./whens";

type Named = BlockSet["show"];

/** The blocks of tabs whose contents depend on the program, by the tabs' names in sets. */
export const CHANGING: Readonly<Record<string, readonly string[]>> = {
  WHEN: [...WHENS, "lb_activate", "lb_deactivate", "lb_state", "lb_time"],
  VARIABLE: ["variables_set", "math_change", "variables_get"],
  PROCEDURE: [
    "procedures_defnoreturn",
    "procedures_defreturn",
    "procedures_callnoreturn",
    "procedures_callreturn",
    "lb_return",
    "lb_set_local",
  ],
};

/** The part of a palette entry that sets use; library blocks are identified by their type. */
export interface Entry {
  readonly kind?: string;
  readonly block?: string;
  readonly type?: string;
}

/** A tab of the palette. */
export interface Tab {
  readonly category?: string;
  readonly custom?: string;
  readonly contents?: readonly Entry[];
}

/** The name that sets use for a block of the palette; empty for entries such as buttons. */
export function nameOf({ block, type }: Entry): string {
  return block ?? type ?? "";
}

/** Whether a set shows only what it names. */
export function isExclusive({ show }: BlockSet): boolean {
  return !!show?.categories?.length || !!show?.blocks?.length;
}

/** A rule for a block outweighs one for its category, and hiding outweighs showing. */
export function shows(set: BlockSet, category: string, block: string): boolean {
  if (set.hide?.blocks?.includes(block)) return false;
  if (set.show?.blocks?.includes(block)) return true;
  if (set.hide?.categories?.includes(category)) return false;
  return !isExclusive(set) || names(set.show, category);
}

function names(named: Named, category: string): boolean {
  return !!named?.categories?.includes(category);
}

/** The blocks of a tab by their names in sets; a tab of only buttons counts as one block. */
export function blocksOf({ category = "", custom, contents }: Tab): readonly string[] {
  const fixed = contents?.map(nameOf).filter(Boolean);
  return fixed ?? CHANGING[custom ?? ""] ?? [category];
}

/** The tabs with at least one shown block, with their shown entries. */
export function shownTabs<T extends Tab>(tabs: readonly T[], set: BlockSet): T[] {
  return tabs.filter((tab) => isShown(tab, set)).map((tab) => ({ ...tab, ...shownContents(tab, set) }));
}

function isShown(tab: Tab, set: BlockSet): boolean {
  const { category = "" } = tab;
  return blocksOf(tab).some((block) => shows(set, category, block));
}

function shownContents({ category = "", contents }: Tab, set: BlockSet): { contents?: readonly Entry[] } {
  return contents ? { contents: shownEntries(contents, category, set) } : {};
}

/** Entries that are not blocks, such as buttons, are always shown. */
export function shownEntries<T extends Entry>(entries: readonly T[], category: string, set: BlockSet): T[] {
  return entries.filter((entry) => entry.kind !== "block" || shows(set, category, nameOf(entry)));
}
