/** Lines in questions and answers, as the views on the screen show them. */

import type { Phrase } from "../../i18n";
import { lineIn } from "../../model/line-in-view";
import type { Page } from "../../model/page";
import type { Asked, Notation, WhySentence } from "../../protocol/messages";

/** The kinds of questions whose subject is a line, and how they ask about a block. */
const OF_LINES: ReadonlyMap<string, string> = new Map([
  ["line", "page-why-ask-line-block"],
  ["not-line", "page-why-ask-not-line-block"],
  ["print", "page-why-ask-print-block"],
  ["not-print", "page-why-ask-not-print-block"],
]);

/** What the answers take for the number of a line where only blocks are shown. */
const BLOCK = "block";

/** A sentence in which blocks may be named. */
export interface SentenceInView {
  readonly phrase: Phrase;
  /** The blocks that it names, each with its words in the sentence. */
  readonly named: readonly { readonly words: string; readonly block: string }[];
}

/** A sentence whose lines and code are those of the view that is shown; where only blocks are, it names these. */
export function sentenceInView(page: Page, sentence: WhySentence): SentenceInView {
  return showsOnlyBlocks(page) ? withBlocks(page, sentence) : { phrase: withLines(page, sentence), named: [] };
}

function withBlocks(page: Page, { phrase, block, inner }: WhySentence): SentenceInView {
  const outer = block ? wordsOf(page, block) : "";
  const within = inner ? wordsOf(page, inner) : "";
  const values = {
    ...phrase.values,
    ...(outer && { line: BLOCK, code: outer }),
    ...(within && { inner: BLOCK, innerCode: within }),
  };
  const named = [
    ...(block && outer ? [{ words: outer, block }] : []),
    ...(inner && within ? [{ words: within, block: inner }] : []),
  ];
  return { phrase: { ...phrase, values }, named };
}

function withLines(page: Page, { phrase, block, inner }: WhySentence): Phrase {
  const values = { ...phrase.values };
  const line = block && lineOf(page, block, Number(values.line));
  if (line) {
    values.line = `${line}`;
    values.code = codeOf(page, line);
  }
  const innerLine = inner && lineOf(page, inner, Number(values.inner));
  if (innerLine) values.inner = `${innerLine}`;
  return { ...phrase, values };
}

export function questionInView(page: Page, { question, phrase, block }: Asked): Phrase {
  const code = OF_LINES.get(question.ask);
  if (block && code && showsOnlyBlocks(page)) {
    const subject = page.views.describeStep("blocks", block);
    if (subject) return { code, values: { ...phrase.values, subject } };
  }
  const line = block && OF_LINES.has(question.ask) && lineOf(page, block, Number(question.subject));
  return line ? { ...phrase, values: { ...phrase.values, subject: `${line}` } } : phrase;
}

/** A text with the parts that name blocks taken out of it. */
export function parted(text: string, { named }: SentenceInView): readonly { text: string; block?: string }[] {
  const found = named
    .map((one) => ({ ...one, at: text.indexOf(one.words) }))
    .filter(({ at }) => at >= 0)
    .sort((one, other) => one.at - other.at);
  const parts: { text: string; block?: string }[] = [];
  let end = 0;
  for (const { words, block, at } of found) {
    if (at < end) continue;
    parts.push({ text: text.slice(end, at) }, { text: words, block });
    end = at + words.length;
  }
  return [...parts, { text: text.slice(end) }].filter((part) => part.text);
}

/** Block-Text's lines, unless Python's are the only ones that the user sees. */
function notationOf({ views }: Page): Notation {
  return views.shows("python") && !views.shows("blocktext") ? "python" : "blocktext";
}

/** The line of a block that was Python's line `ran` in the run; 0 if the block is no longer there. */
function lineOf(page: Page, block: string, ran: number): number {
  const state = page.context.program.state.value;
  const place = state.places.find(([id]) => id === block);
  return place ? lineIn(notationOf(page), state, place, ran) : 0;
}

/** Whether blocks are the only view of the program that the user sees. */
function showsOnlyBlocks({ views }: Page): boolean {
  return !views.shows("blocktext") && !views.shows("python") && views.shows("blocks");
}

/** A block in its own words; empty if it is no longer there. */
function wordsOf({ views }: Page, block: string): string {
  const words = views.describeStep("blocks", block);
  return words && `“${words}”`;
}

function codeOf(page: Page, line: number): string {
  const text = page.context.program.state.value[notationOf(page)].split("\n")[line - 1] ?? "";
  return text
    .split("#")[0]!
    .trim()
    .replace(/:$/, "")
    .replaceAll(/\b(?:function|robot)\./g, "");
}
