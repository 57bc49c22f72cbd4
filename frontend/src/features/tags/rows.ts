/** The tag dictionary as rows that are being edited. */

import type { Names } from "./tag-dictionary";

/** The highest number of a tag. */
export const LAST_TAG = 586;
export const LONGEST_NAME = 100;

export interface Row {
  readonly id: number;
  readonly name: string;
  /** As typed. */
  readonly tag: string;
}

/** The mistake in a row, as the code of a message. */
export type Slip = "page-tags-no-name" | "page-tags-is-number" | "page-tags-twice" | "page-tags-no-tag";

let last = 0;

export function row(name: string, tag: number | string): Row {
  return { id: ++last, name, tag: String(tag) };
}

export function rowsOf(names: Names): readonly Row[] {
  return Object.entries(names).map(([name, tag]) => row(name, tag));
}

export function slipOf({ id, name, tag }: Row, rows: readonly Row[]): Slip | null {
  const wanted = name.trim();
  if (!wanted) return "page-tags-no-name";
  if (/^[\d.]+$/.test(wanted)) return "page-tags-is-number";
  if (rows.some((one) => one.id < id && one.name.trim() === wanted)) return "page-tags-twice";
  return isTag(tag) ? null : "page-tags-no-tag";
}

export function isTag(tag: string): boolean {
  return /^\d+$/.test(tag.trim()) && Number(tag) <= LAST_TAG;
}

/** The names in the rows; null if a row is invalid. */
export function namesOf(rows: readonly Row[]): Names | null {
  if (rows.some((one) => slipOf(one, rows))) return null;
  return Object.fromEntries(rows.map(({ name, tag }) => [name.trim(), Number(tag)]));
}

/** The rows merged with the names of a file, which replace equal names. */
export function merged(rows: readonly Row[], names: Names): readonly Row[] {
  return [...rows.filter(({ name }) => !(name.trim() in names)), ...rowsOf(names)];
}

/** The first unused number. */
export function freeTag(rows: readonly Row[]): number {
  const taken = new Set(rows.map(({ tag }) => Number(tag)));
  let free = 0;
  while (taken.has(free)) free++;
  return Math.min(free, LAST_TAG);
}

export function sameNames(one: Names | null, other: Names | null): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}
