/** The difference between two texts, as changes for CodeMirror. */

import { diff } from "@codemirror/merge";

export interface Change {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

/** Limits for the search of the smallest change, far above a single edit. */
const LIMITS = { scanLimit: 200, timeout: 4 };

/** The lengths of the equal start and end of two texts. */
function commonEnds(before: string, after: string): [front: number, back: number] {
  const most = Math.min(before.length, after.length);
  let front = 0;
  while (front < most && before[front] === after[front]) front += 1;
  let back = 0;
  while (back < most - front && before.at(-1 - back) === after.at(-1 - back)) back += 1;
  return [front, back];
}

/** The one change between two texts, moved by `offset`. */
function onlyChange(before: string, after: string, offset: number): Change[] {
  if (before === after) return [];
  const [front, back] = commonEnds(before, after);
  const insert = after.slice(front, after.length - back);
  return [{ from: offset + front, to: offset + before.length - back, insert }];
}

/** Changes line by line, such as after a rename or an indentation. */
function changedLines(before: readonly string[], after: readonly string[]): Change[] {
  let offset = 0;
  return before.flatMap((line, index) => {
    const changes = onlyChange(line, after[index] ?? "", offset);
    offset += line.length + 1;
    return changes;
  });
}

/** The smallest changes that turn `before` into `after`, so that cursors and marks keep their positions. */
export function changesBetween(before: string, after: string): Change[] {
  const [oldLines, newLines] = [before.split("\n"), after.split("\n")];
  if (oldLines.length === newLines.length) return changedLines(oldLines, newLines);
  return diff(before, after, LIMITS).map(({ fromA, toA, fromB, toB }) => ({
    from: fromA,
    to: toA,
    insert: after.slice(fromB, toB),
  }));
}
