/** Unsaved edits of lessons, kept by the browser while its tab is open. */

import type { Draft } from "./draft";

const KEY = "learnblock.lessons";

type Kept = Readonly<Record<string, Draft>>;

function all(): Kept {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "{}") as Kept;
  } catch {
    // Storage is disabled or contains another program's value: there is nothing to restore.
    return {};
  }
}

/** The unsaved edit of a lesson by its saved name; a new lesson has the empty name. */
export function unsaved(lesson: string): Draft | null {
  return all()[lesson] ?? null;
}

export function keep(draft: Draft): void {
  sessionStorage.setItem(KEY, JSON.stringify({ ...all(), [draft.lesson]: draft }));
}

export function drop(lesson: string): void {
  const { [lesson]: _dropped, ...others } = all();
  sessionStorage.setItem(KEY, JSON.stringify(others));
}
