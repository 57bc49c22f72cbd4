/** How a program is laid out on paper. */

import type { Workspace } from "../../protocol/messages";
import { blocksIn } from "../../views/blocks/folds";
import type { Band } from "../../views/blocks/portable-svg";

type Stack = Workspace["stacks"][number];

/** A block with its first and last line of Block-Text. */
export type Lines = readonly [block: string, first: number, last: number, ...others: readonly unknown[]];

/** A stack of blocks with its lines of Block-Text. */
export interface PrintedStack {
  /** Null for lines that have no blocks. */
  readonly stack: Stack | null;
  /** The number of the first line, from 1. */
  readonly first: number;
  readonly lines: readonly string[];
}

/** The stacks in the order of the text, each with the lines up to its end; stacks outside of the program are last. */
export function linesOfStacks(
  { stacks }: Pick<Workspace, "stacks">,
  text: string,
  places: readonly Lines[],
): PrintedStack[] {
  const lines = text.trimEnd().split("\n");
  const last = new Map(places.map(([block, , end]) => [block, end]));
  const ends = stacks.map((stack) => ({
    stack,
    end: Math.max(0, ...[...blocksIn(stack)].map(({ id }) => last.get(id) ?? 0)),
  }));
  const inText = ends.filter(({ end }) => end > 0).sort((one, other) => one.end - other.end);
  const printed: PrintedStack[] = [];
  let before = 0;
  for (const [index, { stack, end }] of inText.entries()) {
    const to = index === inText.length - 1 ? lines.length : end;
    printed.push({ stack, ...trimmed(lines, before, to) });
    before = to;
  }
  if (inText.length === 0 && text.trim()) printed.push({ stack: null, first: 1, lines });
  return [...printed, ...ends.filter(({ end }) => end === 0).map(({ stack }) => ({ stack, first: 1, lines: [] }))];
}

/** Without the empty lines around them. */
function trimmed(lines: readonly string[], from: number, to: number): { first: number; lines: readonly string[] } {
  let [start, end] = [from, to];
  while (start < end && !lines[start]!.trim()) start++;
  while (end > start && !lines[end - 1]!.trim()) end--;
  return { first: start + 1, lines: lines.slice(start, end) };
}

/**
 * The pieces of a picture, which cut no word unless it is higher than a piece.
 *
 * @param height of the picture.
 * @param words where its words are.
 * @param most the height of a piece.
 */
export function bands(height: number, words: readonly Band[], most: number): Band[] {
  const parts: Band[] = [];
  let top = 0;
  while (height - top > most) {
    const bottom = cutAbove(top + most, words);
    parts.push({ top, bottom: bottom > top ? bottom : top + most });
    top = parts.at(-1)!.bottom;
  }
  return [...parts, { top, bottom: height }];
}

/** The lowest place above that cuts no word. */
function cutAbove(place: number, words: readonly Band[]): number {
  let cut = place;
  for (let hit: Band | undefined; ; cut = hit.top - 1) {
    hit = words.find(({ top, bottom }) => top < cut && cut < bottom);
    if (!hit) return cut;
  }
}
