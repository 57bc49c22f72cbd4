/** What the server says in English, in the user's language: whole sentences, and sentences within them. */

import { language } from "../i18n";

type Book = Record<string, string>;

interface Phrase {
  readonly pattern: RegExp;
  readonly text: string;
}

// Whoever adds a folder adds a language. `{1}` in a sentence stands for a value, or for another sentence.
const files = import.meta.glob<Book>("./*/*.json", { eager: true, import: "default" });
const PLACE = /\{(\d)\}/g;
const books = collect();

/** A sentence of the server in the user's language; in English where nobody has translated it. */
export function said(english: string): string {
  for (const { pattern, text } of books.get(language.value) ?? []) {
    const found = pattern.exec(english);
    if (found) return text.replace(PLACE, (_, place: string) => said(found[Number(place)] ?? ""));
  }
  return english;
}

function collect(): Map<string, readonly Phrase[]> {
  const entries = new Map<string, [string, string][]>();
  for (const [path, book] of Object.entries(files)) {
    const [, code = ""] = path.split("/");
    entries.set(code, [...(entries.get(code) ?? []), ...Object.entries(book)]);
  }
  return new Map([...entries].map(([code, found]) => [code, found.sort(byWords).map(phrase)]));
}

/** What says more by itself is tried first: "{1}; {2}" would fit many a sentence. */
function byWords([one]: [string, string], [other]: [string, string]): number {
  return other.replace(PLACE, "").length - one.replace(PLACE, "").length;
}

function phrase([english, text]: [string, string]): Phrase {
  const literal = english.split(PLACE).filter((_, index) => index % 2 === 0);
  const pattern = literal.map((words) => words.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("(.+?)");
  return { pattern: new RegExp(`^${pattern}$`, "s"), text };
}
