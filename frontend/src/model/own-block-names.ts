/** The names of own blocks and their inputs, as the language allows them. */

import type { Workspace } from "../protocol/messages";
import { DEFINITIONS } from "./own-blocks";
import { WHENS } from "./whens";

/** The words of the language, which the server refuses as names. */
const WORDS = new Set(
  (
    "True False None and or not in if elif else while for break continue return pass def import main when end " +
    "activate deactivate function"
  ).split(" "),
);
const NAMED = new Set([...DEFINITIONS, ...WHENS]);

/** The name in the texts, such as "go_home" for "go home". */
export function nameInTexts(typed: string): string {
  const joined = typed
    .normalize("NFKC")
    .trim()
    .replace(/[^\p{L}\p{M}\p{N}_]+/gu, "_");
  return /^[\p{N}\p{M}]/u.test(joined) ? `_${joined}` : joined;
}

/** What is wrong with a name: the code of a message, or nothing. */
export function nameFault(typed: string, taken: ReadonlySet<string>): string {
  const name = nameInTexts(typed);
  if (!/[\p{L}\p{N}]/u.test(name)) return "page-make-unnamed";
  if (WORDS.has(name)) return "page-make-reserved";
  return taken.has(name.toLowerCase()) ? "page-make-taken" : "";
}

/** The names in a program that a new block can't have, in small letters: those of events, other blocks and variables. */
export function takenNames({ stacks, variables }: Workspace, except = ""): ReadonlySet<string> {
  const named = stacks.flatMap(([first]) => (first && NAMED.has(first.type) && first.id !== except ? [first] : []));
  const names = [...named.map(({ fields }) => String(fields?.NAME)), ...variables.map(({ name }) => name)];
  return new Set(names.map((name) => name.toLowerCase()));
}

/** A name that none of the others has: the wish, or that with a number. */
export function freeName(wish: string, others: readonly string[]): string {
  let name = wish;
  for (let number = 2; others.includes(name); number++) name = `${wish}${number}`;
  return name;
}
