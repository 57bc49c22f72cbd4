/** What differs between two texts, as changes for CodeMirror. */

import { diff } from "@codemirror/merge";
import type { ChangeSpec } from "@codemirror/state";

/** How hard the smallest change is looked for: typing and renaming are well within it. */
const LIMITS = { scanLimit: 400, timeout: 8 };

/** The smallest changes that make `after` of `before`, so that cursors and marks keep their places. */
export function changesBetween(before: string, after: string): ChangeSpec[] {
  return diff(before, after, LIMITS).map(({ fromA, toA, fromB, toB }) => ({
    from: fromA,
    to: toA,
    insert: after.slice(fromB, toB),
  }));
}
