/** Lines in questions and answers, as the views on the screen show them. */

import type { Phrase } from "../../i18n";
import type { Page } from "../../model/page";
import type { Asked, Notation, WhySentence } from "../../protocol/messages";

/** The kinds of questions whose subject is a line. */
const OF_LINES: ReadonlySet<string> = new Set(["line", "not-line", "print", "not-print"]);

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
  if (!place) return 0;
  const [, blocktext, blocktextEnd, python, pythonEnd] = place;
  if (notationOf(page) === "python") return python <= ran && ran <= pythonEnd ? ran : python;
  const branch = branches(state.python, python, pythonEnd).indexOf(ran);
  return branches(state.blocktext, blocktext, blocktextEnd)[branch] ?? blocktext;
}

/** The lines of `elif` and `else` that belong to the statement in some lines of a text. */
export function branches(text: string, first: number, last: number): number[] {
  const lines = text.split("\n");
  const indent = /^\s*/.exec(lines[first - 1] ?? "")?.[0] ?? "";
  const numbers = Array.from({ length: Math.max(0, last - first) }, (_, index) => first + 1 + index);
  return numbers.filter((number) => {
    const line = lines[number - 1] ?? "";
    return line.startsWith(indent) && /^(?:elif|else)\b/.test(line.slice(indent.length));
  });
}

/** The code of a line; where only blocks are shown, the block in its own words. */
function codeOf(page: Page, block: string, line: number): string {
  const { views, context } = page;
  const words = views.shows("blocktext") || views.shows("python") ? "" : views.describeStep("blocks", block);
  if (words) return `“${words}”`;
  const text = context.program.state.value[notationOf(page)].split("\n")[line - 1] ?? "";
  return text
    .split("#")[0]!
    .trim()
    .replace(/:$/, "")
    .replaceAll(/\b(?:function|robot)\./g, "");
}
