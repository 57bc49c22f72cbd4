/** Files that are about to be imported, with the new names that their skills shall have. */

import type { InstalledLibrary, LibraryFile, LibraryRead, SkillClash } from "../messages";

/** A skill whose name somebody else has. */
export interface Renaming {
  /** As the library calls it. */
  readonly skill: string;
  /** Who has that name. */
  readonly place: string;
  /** What it shall be called. */
  readonly name: string;
}

export interface Incoming {
  readonly filename: string;
  /** In base 64. */
  readonly content: string;
  readonly renamings: readonly Renaming[];
  /** What the server has found in it; null until it has told. */
  readonly read: LibraryRead | null;
}

/** What the server is sent of a file. */
export function fileOf({ filename, content, renamings }: Incoming): LibraryFile {
  const renames = Object.fromEntries(renamings.map(({ skill, name }) => [skill, name.trim()]).filter(([, name]) => name));
  return { filename, content, renames };
}

/** A file after the server has looked at it: each new clash is given a name that is likely free. */
export function looked(file: Incoming, read: LibraryRead): Incoming {
  const known = new Set(file.renamings.flatMap(({ skill, name }) => [skill, name.trim()]));
  const clashes = (read.clashes ?? []).filter(({ skill }) => !known.has(skill));
  const found = clashes.map((clash) => renaming(clash, read.library));
  return { ...file, read, renamings: [...file.renamings, ...found] };
}

export function renamed(file: Incoming, skill: string, name: string): Incoming {
  const renamings = file.renamings.map((one) => (one.skill === skill ? { ...one, name } : one));
  return { ...file, renamings };
}

/** Why a new name will not do, if the server has found that somebody has it too. */
export function clashOf(file: Incoming, { skill, name }: Renaming): SkillClash | undefined {
  const wanted = name.trim() || skill;
  return file.read?.clashes?.find((one) => one.skill === wanted);
}

/** Whether nothing keeps it from being imported. */
export function isReady({ read }: Incoming): boolean {
  return Boolean(read?.library) && !read?.problem && !read?.clashes?.length;
}

/** Whether what is installed is as new. */
export function replaces({ read }: Incoming): boolean {
  return Boolean(read?.installed) && read?.is_newer === false;
}

function renaming({ skill, place }: SkillClash, library: InstalledLibrary | undefined | null): Renaming {
  return { skill, place, name: `${library?.name ?? "my"}_${skill}` };
}
