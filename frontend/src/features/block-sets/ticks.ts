/** Converts a set of blocks to ticks in a list, and back. */

import { isExclusive, shows } from "../../model/shown-blocks";
import type { BlockSet } from "../../protocol/messages";

/** A tab with its blocks, by their names in sets. */
export interface Group {
  readonly category: string;
  readonly blocks: readonly string[];
}

/** Names in a set that the palette lacks, such as another user's custom block. */
export interface Absent {
  readonly categories: readonly string[];
  readonly blocks: readonly string[];
}

export interface Ticks {
  /** The names of the blocks that are shown. */
  readonly blocks: ReadonlySet<string>;
  /** Names that the palette lacks but that stay in the set. */
  readonly absent: Absent;
  /** Whether blocks that are added later, or come from libraries, are shown too. */
  readonly later: boolean;
}

/** A set in the dialog, with ticks that may differ from it. */
export interface TickedBlocks {
  readonly base: BlockSet;
  readonly ticks: Ticks;
  readonly changed: boolean;
}

/** The set with these ticks. */
export function setOf({ base, ticks, changed }: TickedBlocks, groups: readonly Group[]): BlockSet {
  if (!changed) return base;
  const { name, title, description } = base;
  return { name, title, description, ...rulesOf(ticks, groups) };
}

export function ticksOf(set: BlockSet, groups: readonly Group[]): Ticks {
  const shown = groups.flatMap(({ category, blocks }) => blocks.filter((block) => shows(set, category, block)));
  return { blocks: new Set(shown), absent: absentIn(set, groups), later: !isExclusive(set) };
}

function absentIn({ show }: BlockSet, groups: readonly Group[]): Absent {
  const categories = new Set(groups.map(({ category }) => category));
  const blocks = new Set(groups.flatMap((group) => group.blocks));
  return {
    categories: (show?.categories ?? []).filter((one) => !categories.has(one)),
    blocks: (show?.blocks ?? []).filter((one) => !blocks.has(one)),
  };
}

/** The rules of a set with these ticks; a whole tab becomes one rule. */
function rulesOf(ticks: Ticks, groups: readonly Group[]): Pick<BlockSet, "show" | "hide"> {
  if (ticks.later) return { hide: mentioned(groups, (block) => !ticks.blocks.has(block)) };
  const { categories, blocks } = mentioned(groups, (block) => ticks.blocks.has(block));
  const { absent } = ticks;
  return { show: { categories: [...categories, ...absent.categories], blocks: [...blocks, ...absent.blocks] } };
}

function mentioned(groups: readonly Group[], meant: (block: string) => boolean) {
  const whole = groups.filter(({ blocks }) => blocks.every(meant));
  const parts = groups.filter((group) => !whole.includes(group));
  return {
    categories: whole.map(({ category }) => category),
    blocks: parts.flatMap(({ blocks }) => blocks.filter(meant)),
  };
}

/** The ticks with some blocks ticked or unticked. */
export function tick(ticks: Ticks, blocks: readonly string[], on: boolean): Ticks {
  const changed = new Set(ticks.blocks);
  for (const block of blocks) on ? changed.add(block) : changed.delete(block);
  return { ...ticks, blocks: changed };
}

/** The ticks without a name that the palette lacks. */
export function forget(ticks: Ticks, name: string): Ticks {
  const { categories, blocks } = ticks.absent;
  const others = (names: readonly string[]) => names.filter((one) => one !== name);
  return { ...ticks, absent: { categories: others(categories), blocks: others(blocks) } };
}
