/** The lines of a text that belong to the lines of Python that ran. */

import type { Notation, Place } from "../protocol/messages";
import type { ProgramState } from "./program";

/** The line of a statement's text that was Python's line `ran` in the run; its first one if that is not known. */
export function lineIn(notation: Notation, texts: Pick<ProgramState, Notation>, place: Place, ran: number): number {
  const [, blocktext, blocktextEnd, python, pythonEnd] = place;
  if (notation === "python") return python <= ran && ran <= pythonEnd ? ran : python;
  const branch = branches(texts.python, python, pythonEnd).indexOf(ran);
  return branches(texts.blocktext, blocktext, blocktextEnd)[branch] ?? sameLine(texts, place, ran) ?? blocktext;
}

/** The only line of the statement's Block-Text that is the same as one of Python, as in raw Python. */
function sameLine({ blocktext, python }: Pick<ProgramState, Notation>, place: Place, ran: number): number | undefined {
  const [, first, last, begin, end] = place;
  if (ran < begin || ran > end) return undefined;
  const wanted = python.split("\n")[ran - 1]?.trim();
  const lines = blocktext.split("\n").slice(first - 1, last);
  const found = lines.flatMap((line, index) => (line.trim() === wanted ? [first + index] : []));
  return found.length === 1 ? found[0] : undefined;
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
