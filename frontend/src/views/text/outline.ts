/** The lines of the program's statements in one text. */

import type { Notation, Place } from "../../protocol/messages";

/** First and last line, from 1. */
export interface Lines {
  readonly first: number;
  readonly last: number;
}

interface Entry extends Lines {
  readonly block: string;
}

function entry(place: Place, notation: Notation): Entry {
  const [block, blocktext, blocktextEnd, python, pythonEnd] = place;
  return notation === "blocktext"
    ? { block, first: blocktext, last: blocktextEnd }
    : { block, first: python, last: pythonEnd };
}

/** The statements of one text, outer ones before inner ones. */
export class Outline {
  private readonly entries: readonly Entry[];
  private readonly indices = new Map<string, number>();

  constructor(places: readonly Place[], notation: Notation) {
    this.entries = places
      .map((place) => entry(place, notation))
      .filter(({ first }) => first > 0)
      .sort((a, b) => a.first - b.first || b.last - a.last);
    this.entries.forEach(({ block }, index) => this.indices.set(block, index));
  }

  /** The lines of a statement before its body. */
  head(block: string): Lines | null {
    const index = this.indices.get(block);
    const own = index === undefined ? undefined : this.entries[index];
    if (index === undefined || !own) return null;
    const next = this.entries[index + 1];
    const nested = next && next.first > own.first && next.first <= own.last;
    return { first: own.first, last: nested ? next.first - 1 : own.last };
  }

  /** The innermost statement that begins on a line. */
  beginningAt(line: number): string | null {
    return this.entries.findLast(({ first }) => first === line)?.block ?? null;
  }

  /** The innermost statement that a line belongs to. */
  around(line: number): string | null {
    return this.entries.findLast(({ first, last }) => first <= line && line <= last)?.block ?? null;
  }
}
