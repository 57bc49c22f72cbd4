/** The blocks of the palette by the words that they say, and by what others call them. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { nameOf } from "../../model/shown-blocks";
import { plain } from "../../ui/plain";
import { wordsFor } from "./meanings";
import { FOREIGN, foreignNames, nearestWords } from "./near";
import type { Item } from "./offers";
import type { GroupInfo, GroupTab } from "./palette-group";

type State = Blockly.serialization.blocks.State;

/** Blocks that do not say the searched words, and a sentence on what they are. */
export interface Nearest {
  readonly sentence: string;
  readonly blocks: readonly Item[];
}

/** A block, and all that it says and can be found by. */
interface Entry {
  readonly block: Item;
  /** Its sentence in the palette, its Python, and what else it is called. */
  readonly shown: string;
  /** The same, and the other choices in its menus. */
  readonly text: string;
}

export class SearchIndex {
  private readonly entries: readonly Entry[];

  constructor(
    blocks: readonly Item[],
    /** Those that depend on the program. */
    private readonly changing: () => readonly Item[],
  ) {
    const undrawn = new Blockly.Workspace();
    this.entries = blocks.flatMap((block) => (block.type ? [entryOf(block, undrawn)] : []));
    undrawn.dispose();
  }

  /** The blocks with all of the words; words that only end or contain them count if none begins with them. */
  matching(words: string): Item[] {
    const parts = plain(words).split(/\s+/);
    const beginning = parts.map((part) => ` ${part}`);
    const begins = this.withAll(beginning);
    return begins.length ? begins : this.withAll(parts);
  }

  /** The blocks with all of the words. One that has them only in a menu gives way to the block that shows them. */
  private withAll(parts: readonly string[]): Item[] {
    const found = this.entries.filter(({ text }) => parts.every((part) => text.includes(part)));
    const isSaid = ({ shown }: Entry) => parts.every((part) => shown.includes(part));
    const alike = new Set(found.filter(isSaid).map(({ block }) => block.like));
    return found.filter((entry) => isSaid(entry) || !alike.has(nameOf(entry.block))).map(({ block }) => block);
  }

  /** What others call by these words. */
  foreign(words: string): Nearest[] {
    const names = foreignNames(words, (name) => t(`page-search-${name}`));
    return names.map((name) => ({ sentence: insteadOf(name), blocks: this.ofTypes(FOREIGN[name] ?? []) }));
  }

  /** The blocks with the most similar word; none if nothing is similar. */
  similar(words: string): Nearest[] {
    const known = new Set(this.entries.flatMap(({ text }) => text.split(/[^\p{L}]+/u)));
    const blocks = new Set(nearestWords(words, known).flatMap((word) => this.matching(word)));
    return blocks.size ? [{ sentence: t("page-search-nearest", { words }), blocks: [...blocks] }] : [];
  }

  private ofTypes(types: readonly string[]): Item[] {
    return types.map((type) => this.ofType(type)).filter((block) => block !== undefined);
  }

  private ofType(type: string): Item | undefined {
    const fixed = this.entries.find(({ block }) => block.type === type)?.block;
    return fixed ?? this.changing().find((block) => block.type === type);
  }
}

function insteadOf(name: string): string {
  const code = `page-search-${name}-say`;
  const sentence = t(code);
  return sentence === code ? "" : sentence;
}

/** The index of a workspace's palette. */
export function indexOf(workspace: Blockly.WorkspaceSvg): SearchIndex {
  const blocks = groupsOf(workspace).flatMap(({ contents }) => contents as readonly Item[]);
  return new SearchIndex(blocks, () => changingOf(workspace));
}

function groupsOf(workspace: Blockly.WorkspaceSvg): readonly GroupInfo[] {
  const items = workspace.options.languageTree?.contents ?? [];
  return items.filter((item) => "tabs" in item) as unknown as GroupInfo[];
}

function entryOf(block: Item, undrawn: Blockly.Workspace): Entry {
  const type = block.type ?? "";
  const made = Blockly.serialization.blocks.append(block as unknown as State, undrawn);
  // With the values that it comes with, which are blocks inside it.
  const fields = made.getDescendants(true).flatMap(({ inputList }) => inputList.flatMap(({ fieldRow }) => fieldRow));
  const sentence = fields.map((field) => field.getText()).join(" ");
  const typed = pythonOf(made) ?? type.replaceAll("_", " ");
  const shown = spaced([sentence, typed, ...wordsFor(nameOf(block), t)]);
  return { block, shown, text: shown + spaced(fields.flatMap(choicesOf)) };
}

/** Words as one searchable text, with a space before each. */
function spaced(words: readonly string[]): string {
  return ` ${plain(words.join(" "))}`;
}

/** The Python code of a block that was made from Python, so that a search for it finds the block; null for others. */
function pythonOf(block: Blockly.Block): string | null {
  const { words, parts } = (block.saveExtraState?.() ?? {}) as { words?: string[]; parts?: string[][] };
  const python = words ?? parts?.flat();
  return python ? `Python ${python.join(" ")}` : null;
}

function choicesOf(field: Blockly.Field): string[] {
  if (!(field instanceof Blockly.FieldDropdown)) return [];
  return field.getOptions(true).flatMap(([label]) => (typeof label === "string" ? [label] : []));
}

/** The blocks that depend on the program; a program without variables is offered one. */
function changingOf(workspace: Blockly.WorkspaceSvg): Item[] {
  const tabs = groupsOf(workspace).flatMap((group) => group.tabs);
  const items = tabs.flatMap(({ custom }) => madeBy(workspace, custom));
  return tabs.some(({ custom }) => custom === "VARIABLE") ? [...items, ...counting()] : items;
}

function madeBy(workspace: Blockly.WorkspaceSvg, custom: GroupTab["custom"]): Item[] {
  const make = custom && workspace.getToolboxCategoryCallback(custom);
  return make ? (make(workspace) as Item[]).filter(({ kind }) => kind === "block") : [];
}

/** The blocks that count, for a program without variables. */
export function counting(): Item[] {
  const fields = { VAR: { name: t("page-search-variable") } };
  const number = (value: number) => ({ shadow: { type: "math_number", fields: { NUM: value } } });
  const blocks = [
    { kind: "block", type: "variables_set", fields, inputs: { VALUE: number(0) } },
    { kind: "block", type: "math_change", fields, inputs: { DELTA: number(1) } },
  ];
  return blocks as Item[];
}
