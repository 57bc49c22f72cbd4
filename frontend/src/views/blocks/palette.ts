/** The palette of a language: the available blocks and their arrangement. */

import * as Blockly from "blockly/core";
import "blockly/blocks";
import * as english from "blockly/msg/en";

import type { Tab } from "../../model/shown-blocks";
import { showIcons } from "./block-icon";
import { registerCodeField } from "./code-field";
import { mixColours } from "./colour-mixer";
import { registerCompact } from "./compact";
import { snapAsInScratch } from "./dragger";
import { type Definition, defineFields, learnAllowed } from "./fields";
import { learnUnits } from "./fields/unit";
import { insertOnClick } from "./insert";
import { registerLines } from "./lines";
import { registerMutators } from "./mutators";
import { offerPlainly } from "./offered";
import type { Item, Section } from "./offers";
import { registerOptional } from "./optional";
import { drawOwnBlocks } from "./own-blocks";
import { registerGroups } from "./palette-group";
import { keepFocus, preferIcons } from "./patches";
import { learnPythonForms, type PythonForm } from "./python-sentences";
import { labelPlaces } from "./renderer";
import { tuneRendering } from "./rendering";
import { registerRest } from "./rest-block";
import { readSentences } from "./sentences";
import { correctStyles, learnCalls } from "./styles";
import { defineTagField } from "./tag-field";
import { forgetUnknown } from "./unknown";
import { compareNamesExactly } from "./variables";
import { registerWhen } from "./when-block";

type Messages = Record<string, string>;

/** A tab of the server's palette; the page groups the tabs. */
export interface PaletteTab extends Tab {
  readonly kind: string;
  readonly name: string;
  readonly category: string;
  readonly group: string;
  readonly contents?: readonly Item[];
}

export interface Toolbox {
  readonly kind: string;
  readonly groups: readonly { readonly group: string; readonly name: string; readonly first: readonly Section[] }[];
  readonly contents: readonly PaletteTab[];
}

/** The server's palette, made from the block configurations. */
export interface Palette {
  readonly language: string;
  readonly definitions: readonly Definition[];
  readonly toolbox: Toolbox;
  readonly messages: Messages;
  /** The styles of calls of the language's functions, by name. */
  readonly calls: Readonly<Record<string, string>>;
  /** The forms of Python that have a sentence. */
  readonly forms: readonly PythonForm[];
  /** The singulars of units, by their plurals. */
  readonly units: Readonly<Record<string, string>>;
}

// Blockly has texts in a hundred languages, 9 MB; each file has those of a language of the page.
const theirs = import.meta.glob<object>("./words/*.ts");
// Texts that Blockly has only in English, mainly for screen readers, and words that differ from its own.
const missing = import.meta.glob<Messages>("./words/*.json", { import: "default" });

/** Fetch the palette in a language, with English texts where Blockly has no others. */
export async function fetchPalette(language: string): Promise<Palette> {
  const [palette, words] = await Promise.all([fetchOwn(language), fetchWords(language)]);
  const messages: object = { ...english, ...words, ...palette.messages };
  return { ...palette, messages: messages as Messages };
}

/** The palette of a page that has no server. */
let given: Palette | null = null;

/** Use a palette instead of asking a server for it. */
export function givePalette(palette: Palette): void {
  given = palette;
}

async function fetchOwn(language: string): Promise<Palette> {
  if (given) return given;
  const response = await fetch(`palette/${encodeURIComponent(language)}.json`);
  if (!response.ok) throw new Error(`the palette did not come: ${response.status} ${response.statusText}`);
  return (await response.json()) as Palette;
}

async function fetchWords(language: string): Promise<object> {
  const path = `./words/${language}`;
  const [usual, own] = await Promise.all([theirs[`${path}.ts`]?.(), missing[`${path}.json`]?.()]);
  return { ...usual, ...own };
}

/** Give Blockly the palette's language and blocks. */
export function installPalette(palette: Palette): void {
  Blockly.setLocale(palette.messages);
  defineBlocks(palette.definitions);
  learnCalls(palette.calls);
  learnPythonForms(palette.forms, palette.messages);
  learnUnits(palette.units);
}

/** Define or redefine types of blocks; blocks in the program keep their shape. */
export function defineBlocks(definitions: readonly Definition[]): void {
  for (const { type } of definitions) {
    forgetUnknown(type);
    // Blockly warns about each type that it already knows.
    delete Blockly.Blocks[type];
  }
  Blockly.common.defineBlocksWithJsonArray(definitions.map(withReadableUnits));
  learnAllowed(definitions);
}

/** In the page's font "°/s" looks like "%s": thin spaces keep it apart. */
function withReadableUnits(definition: Definition): Definition {
  const { message0 } = definition;
  return message0 ? { ...definition, message0: message0.replaceAll("°/s", "°\u2009/\u2009s") } : definition;
}

/** Set up everything that is the same in every language, once. */
export function prepareBlockly(): void {
  compareNamesExactly();
  correctStyles();
  drawOwnBlocks();
  registerMutators();
  registerWhen();
  registerCodeField();
  registerRest();
  defineFields();
  registerOptional();
  defineTagField();
  leaveChecksToServer();
  offerPlainly();
  registerGroups();
  registerLines();
  showIcons();
  mixColours();
  preferIcons();
  insertOnClick();
  snapAsInScratch();
  tuneRendering();
  labelPlaces();
  registerCompact();
  readSentences();
  keepFocus();
  // Never stopped: a program repeats few words, and measuring one causes a layout of the page.
  Blockly.utils.dom.startTextWidthCache();
}

// The server reports the mistakes in a program, the same in all three views. Blockly would disable a
// `break` outside a loop and allow nothing after one, not even a comment; it would unplug what a
// program compares, such as text and a number, and delete calls of undefined functions.
function leaveChecksToServer(): void {
  Blockly.Extensions.unregister("logic_compare");
  Blockly.Extensions.register("logic_compare", () => undefined);
  Blockly.Extensions.unregister("controls_flow_in_loop_check");
  Blockly.Extensions.register("controls_flow_in_loop_check", function (this: Blockly.Block) {
    this.setNextStatement(true);
  });
  delete Blockly.Blocks.procedures_callnoreturn.onchange;
  delete Blockly.Blocks.procedures_callreturn.onchange;
  delete Blockly.Blocks.procedures_ifreturn;
}
