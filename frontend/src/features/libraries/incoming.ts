/** Files to import, with the new names of their skills. */

import type { Phrase } from "../../i18n";
import type { InstalledLibrary, LibraryFile, LibraryRead, SkillClash } from "../../protocol/messages";

/** A skill whose name is already taken. */
export interface Renaming {
  /** Its name in the library. */
  readonly skill: string;
  /** Where that name is taken. */
  readonly place: Phrase;
  /** Its new name. */
  readonly name: string;
}

export interface Incoming {
  readonly filename: string;
  /** In base64. */
  readonly content: string;
  readonly renamings: readonly Renaming[];
  /** What is different from the original, if the library comes from the original LearnBlock. */
  readonly changed?: readonly Phrase[];
  /** What could not be carried over from it. */
  readonly missing?: readonly Phrase[];
  /** The content that the server has read; null until it has answered. */
  readonly read: LibraryRead | null;
}

/** The part of a file that is sent to the server. */
export function fileOf({ filename, content, renamings }: Incoming): LibraryFile {
  const renames = Object.fromEntries(
    renamings.map(({ skill, name }) => [skill, name.trim()]).filter(([, name]) => name),
  );
  return { filename, content, renames };
}

/** A file after the server has read it: each new clash gets a proposed name. */
export function withAnswer(file: Incoming, read: LibraryRead): Incoming {
  const known = new Set(file.renamings.flatMap(({ skill, name }) => [skill, name.trim()]));
  const clashes = (read.clashes ?? []).filter(({ skill }) => !known.has(skill));
  const found = clashes.map((clash) => renaming(clash, read.library));
  return { ...file, read, renamings: [...file.renamings, ...found] };
}

export function renamed(file: Incoming, skill: string, name: string): Incoming {
  const renamings = file.renamings.map((one) => (one.skill === skill ? { ...one, name } : one));
  return { ...file, renamings };
}

/** The clash of a new name that is taken too. */
export function clashOf(file: Incoming, { skill, name }: Renaming): SkillClash | undefined {
  const wanted = name.trim() || skill;
  return file.read?.clashes?.find((one) => one.skill === wanted);
}

/** Whether it can be imported. */
export function isReady({ read }: Incoming): boolean {
  return Boolean(read?.library) && !read?.problem && !read?.clashes?.length;
}

/** Whether the installed version is at least as new. */
export function replaces({ read }: Incoming): boolean {
  return Boolean(read?.installed) && read?.is_newer === false;
}

function renaming({ skill, place }: SkillClash, library: InstalledLibrary | undefined | null): Renaming {
  return { skill, place, name: `${library?.name ?? "my"}_${skill}` };
}
