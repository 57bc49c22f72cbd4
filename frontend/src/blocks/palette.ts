/** The palette of a language: the blocks there are and how they are arranged. */

import * as Blockly from "blockly/core";
import "blockly/blocks";
import * as english from "blockly/msg/en";

import { registerCodeField } from "./code_field";
import { defineFields, learnAllowed, type Definition } from "./fields";
import { keepFocus } from "./focus";
import { registerMutators } from "./mutators";
import { offerPlainly } from "./offered";
import { tuneRendering } from "./rendering";
import { forgetUnknown } from "./unknown";
import { compareNamesExactly } from "./variables";
import { registerWhen } from "./when_block";

type Messages = Record<string, string>;
type Toolbox = Blockly.utils.toolbox.ToolboxInfo;

/** What the server makes of the block configurations. */
export interface Palette {
  readonly language: string;
  readonly definitions: readonly Definition[];
  readonly toolbox: Toolbox;
  readonly messages: Messages;
}

// Blockly brings its words in a hundred languages, 9 MB; a new language of the page is named here too.
const locales: Record<string, () => Promise<object>> = {
  es: () => import("blockly/msg/es"),
};
// What Blockly itself says only in English as yet, above all to screen readers.
const missing = import.meta.glob<Messages>("./words/*.json", { import: "default" });

/** Fetch what the palette needs in a language; English words where Blockly has none. */
export async function fetchPalette(language: string): Promise<Palette> {
  const [palette, words] = await Promise.all([fetchOwn(language), fetchWords(language)]);
  const messages: object = { ...english, ...words, ...palette.messages };
  return { ...palette, messages: messages as Messages };
}

async function fetchOwn(language: string): Promise<Palette> {
  const response = await fetch(`palette/${encodeURIComponent(language)}.json`);
  if (!response.ok) throw new Error(`the palette did not come: ${response.status} ${response.statusText}`);
  return (await response.json()) as Palette;
}

async function fetchWords(language: string): Promise<object> {
  const [theirs, ours] = await Promise.all([locales[language]?.(), missing[`./words/${language}.json`]?.()]);
  return { ...theirs, ...ours };
}

/** Make Blockly speak the palette's language and know its blocks. */
export function installPalette(palette: Palette): void {
  Blockly.setLocale(palette.messages);
  defineBlocks(palette.definitions);
}

/** Define types of blocks, or define them anew: one that is in the program keeps its shape. */
export function defineBlocks(definitions: readonly Definition[]): void {
  for (const { type } of definitions) {
    forgetUnknown(type);
    // Blockly would warn of each that it knows.
    delete Blockly.Blocks[type];
  }
  Blockly.common.defineBlocksWithJsonArray([...definitions]);
  learnAllowed(definitions);
}

/** Teach Blockly, once, what is the same in every language. */
export function prepareBlockly(): void {
  compareNamesExactly();
  registerMutators();
  registerWhen();
  registerCodeField();
  defineFields();
  leaveChecksToServer();
  offerPlainly();
  tuneRendering();
  keepFocus();
  // Never stopped: a program uses few words again and again, and measuring one lays out the page.
  Blockly.utils.dom.startTextWidthCache();
}

// The server says what is wrong with a program, the same in all three views. Blockly would disable a
// `break` outside a loop and let nothing stand behind one, not even a comment; and it would delete
// calls of a function that is defined nowhere.
function leaveChecksToServer(): void {
  Blockly.Extensions.unregister("controls_flow_in_loop_check");
  Blockly.Extensions.register("controls_flow_in_loop_check", function (this: Blockly.Block) {
    this.setNextStatement(true);
  });
  delete Blockly.Blocks["procedures_callnoreturn"].onchange;
  delete Blockly.Blocks["procedures_callreturn"].onchange;
  delete Blockly.Blocks["procedures_ifreturn"];
}
