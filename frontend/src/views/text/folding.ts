/** The lines of Block-Text that open a block, and those that close it. */

import { foldService } from "@codemirror/language";
import { type EditorState, type Extension, StateField, type Text } from "@codemirror/state";

interface Blocks {
  /** The range from the end of the opening line to the end of the last inner line, by line number. */
  readonly inside: ReadonlyMap<number, { readonly from: number; readonly to: number }>;
  /** Lines with a block that is never closed. */
  readonly open: ReadonlySet<number>;
}

const PIECE = String.raw`[^"'#\x60]|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|\x60[^\x60]*\x60`;
const OPENS = new RegExp(String.raw`^(?:${PIECE})*:[ \t]*(?:#.*)?$`);
const RAW = /^\s*python\s*:/;
const CLOSES = /^\s*(?:end|else|elif)\b/;
const END = /^\s*end\b/;

/** Whether a line opens a block. */
export function opensBlock(line: string): boolean {
  return line.includes(":") && OPENS.test(line);
}

function readBlocks(doc: Text): Blocks {
  const inside = new Map<number, { from: number; to: number }>();
  const stack: { line: number; from: number }[] = [];
  let raw = false;
  let number = 0;
  let start = 0;
  for (const line of doc.iterLines()) {
    number += 1;
    if (raw ? END.test(line) : CLOSES.test(line)) {
      const opened = stack.pop();
      if (opened) inside.set(opened.line, { from: opened.from, to: start - 1 });
      raw = false;
    }
    if (!raw && opensBlock(line)) {
      stack.push({ line: number, from: start + line.length });
      raw = RAW.test(line);
    }
    start += line.length + 1;
  }
  return { inside, open: new Set(stack.map(({ line }) => line)) };
}

const blocks = StateField.define<Blocks>({
  create: (state) => readBlocks(state.doc),
  update: (value, transaction) => (transaction.docChanged ? readBlocks(transaction.newDoc) : value),
});

/** Whether the `end` is missing for the block that a line opens, or for an enclosing one. */
export function lacksEnd(state: EditorState): boolean {
  return state.field(blocks).open.size > 0;
}

function fold(state: EditorState, lineStart: number): { from: number; to: number } | null {
  const range = state.field(blocks).inside.get(state.doc.lineAt(lineStart).number);
  return range && range.to > range.from ? range : null;
}

/** Folds blocks of Block-Text. */
export function blocktextFolding(): Extension {
  return [blocks, foldService.of(fold)];
}
