/** The page's words: a folder for each language with a file for each part of the page. */

import { computed } from "@preact/signals";

import { preferences } from "../preferences";

type Words = Record<string, string>;

// Whoever adds a folder adds a language. A word's key is `file.word`.
const files = import.meta.glob<Words>("./*/*.json", { eager: true, import: "default" });

function collect(): Map<string, Map<string, string>> {
  const found = new Map<string, Map<string, string>>();
  for (const [path, words] of Object.entries(files)) {
    const [, code = "", file = ""] = path.split("/");
    const language = found.get(code) ?? new Map<string, string>();
    found.set(code, language);
    for (const [word, text] of Object.entries(words)) {
      language.set(`${file.replace(".json", "")}.${word}`, text);
    }
  }
  return found;
}

const texts = collect();

/** The codes of the languages there are. */
export const languages: readonly string[] = [...texts.keys()];

/** The code of the language in use. */
export const language = computed(() =>
  texts.has(preferences.value.language) ? preferences.value.language : "en",
);

/** What the server names in English, in the user's language where we have words for it. */
export function translated(key: string, english: string): string {
  return texts.get(language.value)?.get(key) ?? texts.get("en")?.get(key) ?? english;
}

/**
 * A text in the user's language, or in English where it has none; `{name}` in it is replaced by the
 * value of that name. Within a component or an effect it follows the language when that changes.
 */
export function t(key: string, values: Record<string, string | number> = {}): string {
  const text = texts.get(language.value)?.get(key) ?? texts.get("en")?.get(key) ?? key;
  return text.replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ""));
}
