/** The Fluent files that Python reads too, and the language in use. */

import { FluentBundle, FluentResource } from "@fluent/bundle";
import { effect, type ReadonlySignal, signal } from "@preact/signals";

/** The values of a message, by name; `@fluent/bundle` formats numbers for the language. */
export type Shown = Readonly<Record<string, string | number>>;

const ENGLISH = "en";

// A folder is a language; the build makes one chunk of its files.
const files = import.meta.glob<string>("../../../src/learnblock/i18n/*/**/*.ftl", {
  query: "?raw",
  import: "default",
});
const bundles = new Map<string, FluentBundle>();
const used = signal(ENGLISH);

/** The codes of the available languages. */
export const languages: readonly string[] = [...new Set(Object.keys(files).map(languageOf))];

/** The code of the language in use: that of the last loaded words. */
export const language: ReadonlySignal<string> = used;

/** Load the words that the user prefers, and again whenever that changes; resolves once the first are loaded. */
export function startLanguage(preferred: ReadonlySignal<string>): Promise<void> {
  return new Promise((resolve) => {
    effect(() => void use(preferred).then(resolve));
  });
}

/** The text of a code in the language in use, else in English, else undefined. */
export function format(code: string, values: Shown): string | undefined {
  const bundle = [used.value, ENGLISH].map((name) => bundles.get(name)).find((one) => one?.hasMessage(code));
  const pattern = bundle?.getMessage(code)?.value;
  return bundle && pattern != null ? bundle.formatPattern(pattern, values, []) : undefined;
}

async function use(preferred: ReadonlySignal<string>): Promise<void> {
  const code = preferred.value;
  const wanted = languages.includes(code) ? code : ENGLISH;
  await Promise.all([load(ENGLISH), load(wanted)]);
  // The user may have chosen a different language meanwhile.
  if (preferred.peek() === code) used.value = wanted;
}

async function load(name: string): Promise<void> {
  if (bundles.has(name)) return;
  const own = Object.entries(files).filter(([path]) => languageOf(path) === name);
  const texts = await Promise.all(own.map(([, read]) => read()));
  const bundle = new FluentBundle(name, { useIsolating: false });
  for (const text of texts) bundle.addResource(new FluentResource(text));
  bundles.set(name, bundle);
}

function languageOf(path: string): string {
  return path.split("/i18n/").at(-1)?.split("/")[0] ?? ENGLISH;
}
