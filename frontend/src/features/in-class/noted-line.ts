/** The line of a program that a teacher's note is about, in a program that may have changed since. */

import type { ProgramState } from "../../model/program";
import type { NotedLine } from "../../protocol/classroom";
import { Outline } from "../../views/text/outline";

/** Characters of a line that are kept with a note. */
const LONGEST = 200;

/** A line of a program, for a note about it; lines count from 1. */
export function notedLine(program: string, number: number): NotedLine {
  return { number, text: beginning(program.split("\n")[number - 1] ?? "") };
}

/** The lines of a program that a note can be about. */
export function linesToNote(program: string): readonly NotedLine[] {
  const lines = program.split("\n").map((_, index) => notedLine(program, index + 1));
  return lines.filter(({ text }) => /\w/.test(text) && text !== "end");
}

/** Where the line of a note is in a program: the same line, else one in its place that begins alike; 0 without one. */
export function numberIn(program: string, { number, text }: NotedLine): number {
  const lines = program.split("\n").map(beginning);
  const same = lines.flatMap((line, index) => (line === text ? [index + 1] : []));
  const [nearest] = same.sort((a, b) => Math.abs(a - number) - Math.abs(b - number));
  return nearest ?? (firstWord(lines[number - 1] ?? "") === firstWord(text) ? number : 0);
}

/** The block of the line of a note; null if the line is gone. */
export function blockOf(line: NotedLine, { blocktext, python, places }: ProgramState): string | null {
  for (const [text, notation] of [
    [blocktext, "blocktext"],
    [python, "python"],
  ] as const) {
    const block = new Outline(places, notation).around(numberIn(text, line));
    if (block) return block;
  }
  return null;
}

function beginning(line: string): string {
  return [...line.trim()].slice(0, LONGEST).join("");
}

function firstWord(line: string): string {
  return /^[\w.]+/.exec(line)?.[0] ?? line;
}

/** What a page with the run of a hand-in tells the page around it. */
export interface ShowLine {
  /** The line of the program in Block-Text whose block is to be shown. */
  readonly showLine: number;
}
