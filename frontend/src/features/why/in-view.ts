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

/** A sentence whose line and code are those of the view that is shown. */
export function sentenceInView(page: Page, { phrase, block, inner }: WhySentence): Phrase {
  const values = { ...phrase.values };
  const line = block && lineOf(page, block, Number(values.line));
  if (block && line) {
    values.line = `${line}`;
    values.code = codeOf(page, block, line);
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

/** The code of a line; where only blocks are shown, the block in its own words. */
function codeOf(page: Page, block: string, line: number): string {
  const { views, context } = page;
  const words = showsOnlyBlocks(page) ? views.describeStep("blocks", block) : "";
  if (words) return `“${words}”`;
  const text = context.program.state.value[notationOf(page)].split("\n")[line - 1] ?? "";
  return text
    .split("#")[0]!
    .trim()
    .replace(/:$/, "")
    .replaceAll(/\b(?:function|robot)\./g, "");
}
