/** The sentences of Python's blocks: what a block shows for its line of Python. */

/** A line of Python with `%1`, `%2` for its parts, and the message with its sentence; the first that fits counts. */
export interface PythonForm {
  readonly type: string;
  readonly python: string;
  readonly word: string;
  /** The words that may begin a block of which this is a further part; none for any. */
  readonly of: readonly string[];
}

/** A part of a sentence: our words, the program's words, or the number of a socket. */
export type Part =
  | { readonly kind: "label"; readonly text: string }
  | { readonly kind: "words"; readonly text: string; readonly place: string }
  | { readonly kind: "socket"; readonly number: number };

interface Known extends PythonForm {
  readonly pattern: RegExp;
  readonly sentence: string;
}

/** Where a value is in the words of a line. */
const SOCKET = "\u0000";

let forms: readonly Known[] = [];

export function learnPythonForms(known: readonly PythonForm[], messages: Readonly<Record<string, string>>): void {
  forms = known.map((form) => ({ ...form, pattern: patternOf(form.python), sentence: messages[form.word] ?? "" }));
}

/** The sentence of a line of Python; null if its block shows Python's words. */
export function sentenceOf(type: string, words: readonly string[], begun: string): Part[] | null {
  const line = words.join(SOCKET);
  const found = fitting(type, line, begun);
  if (!found?.form.sentence) return null;
  return found.form.sentence
    .split(/(%\d)/)
    .filter((text) => text.trim())
    .flatMap((text) => (text.startsWith("%") ? partsOf(line, found.match, text) : [label(text)]));
}

/** The words of a line with other words in one place of its sentence; the same words if they don't fit there. */
export function reworded(
  type: string,
  words: readonly string[],
  begun: string,
  { place, text }: { place: string; text: string },
): string[] {
  const line = words.join(SOCKET);
  const span = fitting(type, line, begun)?.match.indices?.[Number(place.slice(1))];
  return span ? (line.slice(0, span[0]) + text + line.slice(span[1])).split(SOCKET) : [...words];
}

function fitting(type: string, line: string, begun: string): { form: Known; match: RegExpExecArray } | null {
  for (const form of forms) {
    if (form.type !== type || (form.of.length && !form.of.includes(begun))) continue;
    const match = form.pattern.exec(line);
    if (match) return { form, match };
  }
  return null;
}

/** White space is free where the form has some; a single `=` is no part of another sign. */
function patternOf(python: string): RegExp {
  const source = python
    .split(/(%\d| = | )/)
    .map((text) => {
      if (text.startsWith("%")) return "(.+?)";
      if (text === " = ") return "\\s*(?<![-+*/%@&|^<>=!:])=(?!=)\\s*";
      return text === " " ? "\\s+" : text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
    })
    .join("");
  return new RegExp(`^${source}$`, "d");
}

/** The words and sockets in a part of a line; words without a socket beside them can be changed. */
function partsOf(line: string, match: RegExpExecArray, place: string): Part[] {
  const [start, end] = match.indices![Number(place.slice(1))]!;
  const first = line.slice(0, start).split(SOCKET).length - 1;
  const texts = line.slice(start, end).split(SOCKET);
  if (texts.length === 1) return [{ kind: "words", text: texts[0]!, place }];
  return texts.flatMap((text, at): Part[] => [
    ...(text.trim() ? [label(text)] : []),
    ...(at < texts.length - 1 ? [{ kind: "socket" as const, number: first + at }] : []),
  ]);
}

function label(text: string): Part {
  return { kind: "label", text: text.trim() };
}
