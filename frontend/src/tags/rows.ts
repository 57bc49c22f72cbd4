/** The dictionary of tags as lines that are being edited. */

import type { Names } from "./dictionary";

/** The highest number of a tag. */
export const LAST_TAG = 586;
export const LONGEST_NAME = 100;

export interface Row {
  readonly id: number;
  readonly name: string;
  /** As it was typed. */
  readonly tag: string;
}

/** What is wrong with a line, as a key of the translations. */
export type Slip = "tags.noName" | "tags.isNumber" | "tags.twice" | "tags.noTag";

let last = 0;

export function row(name: string, tag: number | string): Row {
  return { id: ++last, name, tag: String(tag) };
}

export function rowsOf(names: Names): readonly Row[] {
  return Object.entries(names).map(([name, tag]) => row(name, tag));
}

export function slipOf({ id, name, tag }: Row, rows: readonly Row[]): Slip | null {
  const wanted = name.trim();
  if (!wanted) return "tags.noName";
  if (/^[\d.]+$/.test(wanted)) return "tags.isNumber";
  if (rows.some((one) => one.id < id && one.name.trim() === wanted)) return "tags.twice";
  return isTag(tag) ? null : "tags.noTag";
}

export function isTag(tag: string): boolean {
  return /^\d+$/.test(tag.trim()) && Number(tag) <= LAST_TAG;
}

/** The names that the lines give; null while one of them is wrong. */
export function namesOf(rows: readonly Row[]): Names | null {
  if (rows.some((one) => slipOf(one, rows))) return null;
  return Object.fromEntries(rows.map(({ name, tag }) => [name.trim(), Number(tag)]));
}

/** The lines with the names of a file, which go before those there are. */
export function merged(rows: readonly Row[], names: Names): readonly Row[] {
  return [...rows.filter(({ name }) => !(name.trim() in names)), ...rowsOf(names)];
}

/** The first number that no line has. */
export function freeTag(rows: readonly Row[]): number {
  const taken = new Set(rows.map(({ tag }) => Number(tag)));
  let free = 0;
  while (taken.has(free)) free++;
  return Math.min(free, LAST_TAG);
}

export function sameNames(one: Names | null, other: Names | null): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}
