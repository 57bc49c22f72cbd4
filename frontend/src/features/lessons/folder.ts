/** The files that a user has chosen, if they are the folder of a lesson. */

/** A folder with a lesson: its name, and its files by their paths inside. */
export interface LessonFolder {
  readonly name: string;
  readonly files: ReadonlyMap<string, File>;
}

/** Only the folder that was chosen can be a lesson, not one in it. */
const MAIN = /^([^/]+)\/lesson\.toml$/;

export function lessonFolderOf(files: readonly File[]): LessonFolder | null {
  const name = files.map(({ webkitRelativePath }) => MAIN.exec(webkitRelativePath)?.[1]).find(Boolean);
  if (!name) return null;
  const inside = files.map((file) => [file.webkitRelativePath.slice(name.length + 1), file] as const);
  return { name, files: new Map(inside.filter(([path]) => !isHidden(path))) };
}

/** What file managers and editors add, which may be large. */
function isHidden(path: string): boolean {
  return path.split("/").some((part) => part.startsWith("."));
}
