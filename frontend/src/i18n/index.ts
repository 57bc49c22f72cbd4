/** The texts of the page: its own words, and the server's messages by code. */

import { format, language, languages, type Shown, startLanguage } from "./words";

export { language, languages, startLanguage };

/** A text in several languages, such as the label of a block. */
interface Multilingual {
  readonly texts: Readonly<Record<string, string>>;
}

type Value = string | number | Phrase | Multilingual | readonly (string | Phrase)[];

/** A message of the server: a code and named values. */
export interface Phrase {
  readonly code: string;
  readonly values?: Readonly<Record<string, Value>>;
}

/**
 * A phrase in the user's language. Within a component or an effect it is updated when the language
 * changes. Text that is not a code, such as the message of a library's exception, is shown as it is.
 */
export function say(phrase: Phrase | string): string {
  if (typeof phrase === "string") return phrase;
  const { code, values = {} } = phrase;
  const shown = Object.entries(values).map(([name, value]) => [name, show(value)] as const);
  return format(code, Object.fromEntries(shown)) ?? code;
}

/** One of the page's own words in the user's language; it is updated like that of `say`. */
export function t(code: string, values: Shown = {}): string {
  return format(code, values) ?? code;
}

/** The page's word for an English name from the server, or that name if there is no word. */
export function translated(code: string, english: string): string {
  return format(code, {}) ?? english;
}

/** The title or goal of a world in the user's language; names in third-party worlds are unchanged. */
export function worldName(english: string): string {
  const tag = /^tag (\d+)$/.exec(english)?.[1];
  if (tag) return t("page-catalog-goal-tag", { number: tag });
  const word = english.toLowerCase().replace(/[^a-z0-9]+/g, "-");
  return translated(`page-catalog-name-${word}`, english);
}

function show(value: Value): string | number {
  if (typeof value === "string" || typeof value === "number") return value;
  if ("texts" in value) return value.texts[language.value] ?? value.texts.en ?? "";
  return "code" in value ? say(value) : value.map((one) => (typeof one === "string" ? one : say(one))).join(", ");
}
