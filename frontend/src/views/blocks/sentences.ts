/** Lets a screen reader read a block as its sentence: "turn right by 90 °" without a pause after each value. */

import * as Blockly from "blockly/core";

import { type Labelled, labelInputs } from "./patches";
import { wordOf } from "./renderer";

type Verbosity = Blockly.utils.aria.Verbosity;

/** Around the words of an input while a whole block is read; they are in no text. */
const [BEGIN, END] = ["\u0001", "\u0002"];
const SEAM = new RegExp(`${END},? ${BEGIN}`, "g");
const MARKS = new RegExp(`[${BEGIN}${END}]`, "g");

/** Call it once, before the first block is created. */
export function readSentences(): void {
  labelInputs(wordsOf, {
    mark: (words) => `${BEGIN}${words}${END}`,
    join: (label) => label.replace(SEAM, " ").replace(MARKS, ""),
  });
}

/** The fields of an input, and the sentence of its value or what is missing. */
function wordsOf(input: Labelled, verbosity: Verbosity | undefined, withValue: boolean): string {
  const { LOQUACIOUS } = Blockly.utils.aria.Verbosity;
  const fields = input.fieldRow
    .filter((field) => field.isVisible())
    // The icon of a block has an empty list as its label.
    .map((field) => String(field.computeAriaLabel(verbosity === LOQUACIOUS)));
  return [...fields, withValue ? plugged(input, verbosity) : ""].filter(Boolean).join(" ");
}

function plugged(input: Labelled, verbosity: Verbosity | undefined): string {
  if (input.type !== Blockly.inputs.inputTypes.VALUE) return "";
  const value = input.connection?.targetBlock();
  if (value?.isInsertionMarker()) return "";
  if (!value) return [Blockly.Msg.INPUT_LABEL_EMPTY, wordOf(input)].filter(Boolean).join(": ");
  const inputs = value.inputList as Labelled[];
  return inputs
    .map((one) => one.getLabel(verbosity))
    .filter(Boolean)
    .join(" ");
}
