/** What the files are that a user has chosen: a program, or libraries. */

import { t } from "../i18n";
import { LIMITS } from "../protocol/messages";

export type Upload =
  /** With the text files of the original LearnBlock's libraries beside it. */
  | { readonly kind: "program"; readonly file: File; readonly libraries: readonly File[] }
  | { readonly kind: "libraries"; readonly files: readonly File[] }
  | { readonly kind: "several"; readonly count: number }
  | { readonly kind: "unknown" };

/** The ending of a library. */
export const LIBRARY = ".lblib";
/** The endings of a library of the original LearnBlock; it always has the first file. */
export const ORIGINAL_LIBRARY = [".lb", ".py", ".conf"] as const;
const [LIBRARY_TEXT] = ORIGINAL_LIBRARY;
/** The ending of a project of the original LearnBlock. */
const ORIGINAL_PROJECT = ".blockProject";
/** The files of the original LearnBlock that can be opened, which may be binary. */
export const ORIGINAL = [ORIGINAL_PROJECT, LIBRARY_TEXT];
const PROGRAMS = [".learnblock", ".bt", ORIGINAL_PROJECT];
export const UPLOADS = [...PROGRAMS, LIBRARY, ...ORIGINAL_LIBRARY];
/** The largest files in bytes; a project has everything that it needs in it. */
const LARGEST: Readonly<Record<string, number>> = {
  learnblock: LIMITS.Import.text,
  lb: LIMITS.ConvertLibrary.content,
  conf: LIMITS.ConvertLibrary.configuration,
};
const LARGEST_OTHER = LIMITS.ImportOriginal.content;

/** Programs come first, because their libraries may be beside them. */
export function uploadOf(files: readonly File[]): Upload {
  const texts = withEnding(files, [LIBRARY_TEXT]);
  const programs = [...withEnding(files, PROGRAMS), ...loosePython(files, texts)];
  if (programs.length > 1) return { kind: "several", count: programs.length };
  if (programs[0]) return { kind: "program", file: programs[0], libraries: texts };
  if (files.length === 1 && texts[0]) return { kind: "program", file: texts[0], libraries: [] };
  const libraries = withEnding(files, [LIBRARY, ...ORIGINAL_LIBRARY]);
  return libraries.length ? { kind: "libraries", files: libraries } : { kind: "unknown" };
}

export function withEnding(files: readonly File[], endings: readonly string[]): File[] {
  // Some systems write endings in capitals.
  return files.filter(({ name }) => endings.some((ending) => name.toLowerCase().endsWith(ending.toLowerCase())));
}

/** The name of a file without its ending. */
export function stemOf({ name }: File): string {
  return name.replace(/\.\w+$/, "");
}

/** Why the server would refuse a file for its size; null if it would not. */
export function sizeProblem(files: readonly File[]): string | null {
  const large = files.find((one) => one.size > limitOf(one));
  return large ? t("page-project-large-file", { name: large.name, limit: limitOf(large) }) : null;
}

function limitOf({ name }: File): number {
  return LARGEST[name.slice(name.lastIndexOf(".") + 1).toLowerCase()] ?? LARGEST_OTHER;
}

/** The Python files that do not belong to a library. */
function loosePython(files: readonly File[], texts: readonly File[]): File[] {
  const stems = new Set(texts.map(stemOf));
  return withEnding(files, [".py"]).filter((file) => !stems.has(stemOf(file)));
}
