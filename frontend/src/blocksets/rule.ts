/** Which blocks a set shows; the server knows the same sets and never asks. */

import type { BlockSet } from "../messages";

type Named = BlockSet["show"];

/** Blocks of a tab whose contents depend on the program, and what the tab is called among sets. */
export const CHANGING: Readonly<Record<string, readonly string[]>> = {
  WHEN: ["lb_when", "lb_activate", "lb_deactivate", "lb_state", "lb_time"],
  VARIABLE: ["variables_set", "math_change", "variables_get"],
  PROCEDURE: ["procedures_defnoreturn", "procedures_defreturn", "procedures_callnoreturn", "procedures_callreturn"],
};

/** An entry of the palette as far as sets are concerned; libraries' blocks go by their type. */
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

/** What sets call a block of the palette; empty for what is none, such as a button. */
export function nameOf({ block, type }: Entry): string {
  return block ?? type ?? "";
}

/** Whether a set shows nothing but what it names. */
export function isExclusive({ show }: BlockSet): boolean {
  return !!show?.categories?.length || !!show?.blocks?.length;
}

/** What is said of a block goes before what is said of its category, and hiding before showing. */
export function shows(set: BlockSet, category: string, block: string): boolean {
  if (set.hide?.blocks?.includes(block)) return false;
  if (set.show?.blocks?.includes(block)) return true;
  if (set.hide?.categories?.includes(category)) return false;
  return !isExclusive(set) || names(set.show, category);
}

function names(named: Named, category: string): boolean {
  return !!named?.categories?.includes(category);
}

/** The blocks of a tab as sets name them; a tab of buttons alone stands for itself. */
export function blocksOf({ category = "", custom, contents }: Tab): readonly string[] {
  const fixed = contents?.map(nameOf).filter(Boolean);
  return fixed ?? CHANGING[custom ?? ""] ?? [category];
}

/** The tabs that have something to show, with what they show. */
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

/** What is no block, such as a button, is always shown. */
export function shownEntries<T extends Entry>(entries: readonly T[], category: string, set: BlockSet): T[] {
  return entries.filter((entry) => entry.kind !== "block" || shows(set, category, nameOf(entry)));
}
