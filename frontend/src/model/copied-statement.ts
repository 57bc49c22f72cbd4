/** A statement that was copied as a block can be pasted as text. */

import type { Notation, Place } from "../protocol/messages";

/** The program as it is in both texts. */
export interface Texts {
  readonly blocktext: string;
  readonly python: string;
  readonly places: readonly Place[];
}

export class CopiedStatement {
  private texts: Readonly<Record<Notation, string>> | null = null;

  /** Keep a statement, given by its block's id; return its Block-Text, or null if the texts do not have it. */
  keep({ blocktext, python, places }: Texts, block: string): string | null {
    const place = places.find(([id]) => id === block);
    if (!place) return null;
    const [, first, last, pythonFirst, pythonLast] = place;
    this.texts = { blocktext: lines(blocktext, first, last), python: lines(python, pythonFirst, pythonLast) };
    return this.texts.blocktext;
  }

  /** What a text in a notation is pasted as: the statement that was copied is written in this notation. */
  pasted(text: string, notation: Notation): string {
    return text === this.texts?.blocktext ? this.texts[notation] : text;
  }
}

/** Some lines of a text, from 1, without the indentation of the first. */
function lines(text: string, first: number, last: number): string {
  const chosen = text.split("\n").slice(first - 1, last);
  const indent = chosen[0]?.search(/\S/) ?? 0;
  return chosen.map((line) => `${line.slice(Math.min(Math.max(line.search(/\S/), 0), indent))}\n`).join("");
}
