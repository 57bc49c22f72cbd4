/** The shape of blocks with Python: words that can be edited, and sockets for the values between them. */

import * as Blockly from "blockly/core";

import { type Part, reworded, sentenceOf } from "./python-sentences";

/** The words of a line, one more than the values between them; or those of each part of a block. */
interface PythonState {
  words?: string[];
  parts?: string[][];
}
type Python = Blockly.Block & { python_: PythonState };

/** A line or the first line of a part. */
interface Line {
  readonly words: readonly string[];
  /** The number of its first socket. */
  readonly first: number;
  /** The part of the block that it begins; null for a line. */
  readonly part: number | null;
}

/** Python that stays Python: the inputs `A0`... are its values; `DO0`... are its bodies. */
const PYTHON = {
  saveExtraState(this: Python): PythonState {
    return this.python_;
  },
  loadExtraState(this: Python, state: PythonState): void {
    this.python_ = state;
    this.removeInput("PLACE", true);
    const lines = state.parts ?? [state.words ?? []];
    let first = 0;
    lines.forEach((words, place) => {
      addLine(this, { words, first, part: state.parts ? place : null });
      first += Math.max(0, words.length - 1);
      if (state.parts) addBody(this, place);
    });
  },
};

/** The mouth of a part; a `match` has only cases, each below it on a row of its own. */
function addBody(block: Python, place: number): void {
  if (place === 0 && beginning(block.python_) === "match") block.appendEndRowInput("CASES");
  else block.appendStatementInput(`DO${place}`);
}

function addLine(block: Python, line: Line): void {
  const sentence = sentenceOf(block.type, line.words, beginning(block.python_));
  if (sentence) addSentence(block, line, sentence);
  else addWords(block, line);
}

/** The word that begins a block with several parts. */
function beginning({ parts }: PythonState): string {
  return parts?.[0]?.[0]?.replace(/^async\s/, "").match(/\w+/)?.[0] ?? "";
}

function addSentence(block: Python, { first, part }: Line, sentence: readonly Part[]): void {
  let fields: Blockly.Field[] = [];
  const flush = (input: Blockly.Input) => {
    for (const field of fields) input.appendField(field);
    fields = [];
  };
  for (const one of sentence) {
    if (one.kind === "label") fields.push(new Blockly.FieldLabel(one.text));
    else if (one.kind === "words") fields.push(new WordsField(one.text, part, one.place));
    else flush(block.appendValueInput(`A${first + one.number}`));
  }
  if (fields.length || part !== null) flush(block.appendDummyInput(`WORDS${part ?? ""}`));
}

/** Add words and the inputs between them; words alone can be edited. */
function addWords(block: Python, { words, first, part }: Line): void {
  const place = part ?? "";
  const last = words.length - 1;
  if (last < 1) {
    block.appendDummyInput(`WORDS${place}`).appendField(new Blockly.FieldTextInput(words[0] ?? ""), `CODE${place}`);
    return;
  }
  words.slice(0, last).forEach((text, index) => {
    const input = block.appendValueInput(`A${first + index}`);
    if (text.trim()) input.appendField(text.trim());
  });
  const ending = words[last]?.trim();
  if (ending || part !== null) block.appendDummyInput(`WORDS${place}`).appendField(ending ?? "");
}

/** Words of a sentence, such as a name; they are saved in the block's extra state. */
class WordsField extends Blockly.FieldTextInput {
  constructor(
    text: string,
    private readonly part: number | null,
    private readonly place: string,
  ) {
    super(text);
  }

  override isSerializable(): boolean {
    return false;
  }

  protected override doClassValidation_(text?: unknown): string | null {
    const words = String(text ?? "").trim();
    return words || null;
  }

  protected override doValueUpdate_(text: string): void {
    const changed = text !== this.value_;
    super.doValueUpdate_(text);
    const block = this.getSourceBlock() as Python | null;
    if (block && changed) this.write(block, text);
  }

  private write(block: Python, text: string): void {
    const { part, place } = this;
    const begun = beginning(block.python_);
    const change = (words: readonly string[]) => reworded(block.type, words, begun, { place, text });
    const { words = [], parts = [] } = block.python_;
    block.python_ =
      part === null ? { words: change(words) } : { parts: parts.map((one, at) => (at === part ? change(one) : one)) };
  }
}

export function registerPython(): void {
  Blockly.Extensions.registerMutator("lb_python_mutator", PYTHON, function (this: Python) {
    this.python_ = {};
  });
}
