/** The blocks that a group of the palette offers: first the few that matter, then all others. */

import { isStoodIn, STOOD_IN } from "../../model/robots";
import { type Entry, nameOf } from "../../model/shown-blocks";
import { STAGES, type Stage } from "../../model/stages";
import { labelsOf } from "./line-labels";

export type Item = Entry & { readonly needs?: readonly string[]; readonly lacking?: boolean } & {
  /** The name of a block that also does what this one does. */
  readonly like?: string;
  /** The stage from which the palette shows it; the search finds it at every stage. */
  readonly stage?: Stage;
};

/** Blocks under one heading, by their names in sets or that of a whole tab. */
export interface Section {
  readonly heading: string;
  readonly blocks: readonly string[];
}

/** A tab with its current blocks. */
export interface FilledTab {
  readonly name: string;
  readonly category: string;
  readonly items: readonly Item[];
}

export interface Offer {
  readonly tabs: readonly FilledTab[];
  /** What to show first; null to show everything. */
  readonly first: readonly Section[] | null;
  /** Whether the others are shown, too. */
  readonly open: boolean;
  /** What the robot lacks of the needs of blocks. */
  readonly lacks: ReadonlySet<string>;
  readonly stage: Stage;
}

/** The words of the palette. */
export interface Words {
  more(count: number): string;
  fewer(): string;
  /** Why the robot can't do blocks with this need. */
  missing(need: string): string;
  /** That this computer does it in the robot's place. */
  standIn(need: string): string;
  /** From which stage the palette shows blocks. */
  from(stage: Stage): string;
}

export const MORE = "LB_MORE";

/** The entries of a group's flyout, below what this computer does for the robot. */
export function offered(offer: Offer, words: Words): Item[] {
  const entries = entriesOf(offer, words);
  return [...standInLabels(entries, offer.lacks, words), ...entries];
}

function entriesOf(whole: Offer, words: Words): Item[] {
  const offer = { ...whole, tabs: whole.tabs.map((tab) => upTo(whole.stage, withoutAlike(tab))) };
  const tabs = offer.tabs.map((tab) => ({ ...tab, items: tab.items.filter((item) => !missing(item, offer.lacks)) }));
  const first = offer.first ? offer.first.map((section) => filled(section, tabs)) : [];
  const begun = first.flatMap(({ items }) => items);
  const shown = new Set(begun.map(nameOf).filter(Boolean));
  const rest = tabs.map((tab) => ({
    heading: tab.name,
    items: tab.items.filter((item) => !isShown(item, shown, begun)),
  }));
  const lacking = offer.tabs.flatMap(({ items }) => items).filter((item) => missing(item, offer.lacks));
  const others = [...headed(rest, offer.tabs.length > 1), ...lackingItems(lacking, offer.lacks, words)];
  const count = others.filter(isBlock).length;
  if (count === 0) return headed(first, true);
  if (begun.length === 0) return others;
  if (!offer.open) return [...headed(first, true), button(words.more(count))];
  return [...headed(first, true), ...others, button(words.fewer())];
}

/**
 * Found blocks: those that the palette shows first come first, then those of later stages, and those that the robot
 * can't do last.
 */
export function found(
  all: readonly Item[],
  first: readonly Section[],
  { lacks, stage }: Pick<Offer, "lacks" | "stage">,
  words: Words,
): Item[] {
  const items = all.filter((item) => !isLater(item, stage));
  const order = first.flatMap(({ blocks }) => blocks);
  const rank = (item: Item) => (order.includes(nameOf(item)) ? order.indexOf(nameOf(item)) : order.length);
  const able = items.filter((item) => !missing(item, lacks));
  return [
    ...able.sort((one, other) => rank(one) - rank(other)),
    ...laterItems(all, stage, words),
    ...lackingItems(
      items.filter((item) => missing(item, lacks)),
      lacks,
      words,
    ),
  ];
}

/** A tab without the blocks that another of its blocks can become. */
function withoutAlike(tab: FilledTab): FilledTab {
  const names = new Set(tab.items.map(nameOf));
  return { ...tab, items: tab.items.filter(({ like }) => like === undefined || !names.has(like)) };
}

/** A tab without the blocks of later stages. */
function upTo(stage: Stage, tab: FilledTab): FilledTab {
  return { ...tab, items: tab.items.filter((item) => !isLater(item, stage)) };
}

function isLater({ stage: from }: Item, stage: Stage): boolean {
  return from !== undefined && STAGES.indexOf(from) > STAGES.indexOf(stage);
}

/** The blocks of later stages, with the stage above them. */
function laterItems(items: readonly Item[], stage: Stage, words: Words): Item[] {
  const later = items.filter((item) => isLater(item, stage));
  return STAGES.flatMap((from) => {
    const own = later.filter((item) => item.stage === from);
    return own.length ? [label(words.from(from)), ...own] : [];
  });
}

interface Headed {
  readonly heading: string;
  readonly items: readonly Item[];
}

function filled({ heading, blocks }: Section, tabs: readonly FilledTab[]): Headed {
  const items = blocks.flatMap((name) => tabs.flatMap((tab) => itemsNamed(name, tab)));
  return { heading, items };
}

function itemsNamed(name: string, { category, items }: FilledTab): readonly Item[] {
  return category === name ? items : items.filter((item) => nameOf(item) === name);
}

// A button has no name, but it is the same object.
function isShown(item: Item, names: ReadonlySet<string>, items: readonly Item[]): boolean {
  return names.has(nameOf(item)) || items.includes(item);
}

function headed(sections: readonly Headed[], withHeadings: boolean): Item[] {
  return sections
    .filter(({ items }) => items.length > 0)
    .flatMap(({ heading, items }) => [...(withHeadings && heading ? [label(heading)] : []), ...items]);
}

function lackingItems(items: readonly Item[], lacks: ReadonlySet<string>, words: Words): Item[] {
  const needs = new Set(items.map((item) => missing(item, lacks)!));
  return [...needs].flatMap((need) => [
    ...labelsOf(words.missing(need)),
    ...items.filter((item) => missing(item, lacks) === need).map((item) => ({ ...item, lacking: true })),
  ]);
}

function standInLabels(items: readonly Item[], lacks: ReadonlySet<string>, words: Words): Item[] {
  const needs = new Set(items.flatMap((item) => item.needs ?? []).filter((need) => lacks.has(need) && isStoodIn(need)));
  const [only = ""] = needs;
  return needs.size ? labelsOf(words.standIn(needs.size > 1 ? STOOD_IN : only)) : [];
}

/** The first need of a block that neither the robot nor this computer serves. */
function missing({ needs }: Item, lacks: ReadonlySet<string>): string | undefined {
  return needs?.find((need) => lacks.has(need) && !isStoodIn(need));
}

function isBlock({ kind }: Item): boolean {
  return kind === "block";
}

function label(text: string): Item {
  return { kind: "label", text, "web-class": "lbHeading" } as Item;
}

function button(text: string): Item {
  return { kind: "button", text, callbackkey: MORE, "web-class": "lbMore" } as Item;
}
