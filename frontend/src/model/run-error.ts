/** The error that the last run ended with, where each view shows it. */

import { computed, type ReadonlySignal } from "@preact/signals";

import { type Phrase, say, t } from "../i18n";
import type { Ended, Notation, Problem } from "../protocol/messages";
import { lineIn } from "./line-in-view";
import type { Program, ProgramState } from "./program";
import type { Running } from "./running";

/** The meanings of Python's most common errors. */
const MEANINGS: Readonly<Record<string, string>> = {
  ZeroDivisionError: "page-problems-run-zero-division-error",
  NameError: "page-problems-run-name-error",
  UnboundLocalError: "page-problems-run-unbound-local-error",
  TypeError: "page-problems-run-type-error",
  ValueError: "page-problems-run-value-error",
  IndexError: "page-problems-run-index-error",
  KeyError: "page-problems-run-key-error",
  AttributeError: "page-problems-run-attribute-error",
  RecursionError: "page-problems-run-recursion-error",
};

/** A problem for each view; none once the program has been changed, which may have fixed it. */
export function runError(program: Program, running: Running): ReadonlySignal<readonly Problem[]> {
  const ran = computed(() => running.ended.value && program.state.peek().python);
  return computed(() => {
    const state = program.state.value;
    const ended = running.ended.value;
    return ended?.ended === "error" && ran.value === state.python ? problemsOf(ended, state) : [];
  });
}

function problemsOf(ended: Ended, state: ProgramState): readonly Problem[] {
  const place = state.places.find(([block]) => block === ended.block);
  if (!place) return [];
  const [block, blocktext, , python] = place;
  const shared = { code: "run", message: { code: explained(ended.message ?? "") }, severity: "error", block } as const;
  const inText = (view: Notation, first: number) =>
    first > 0 ? [{ ...shared, view, line: lineIn(view, state, place, ended.line ?? 0) }] : [];
  return [{ ...shared, view: "blocks" }, ...inText("blocktext", blocktext), ...inText("python", python)];
}

/** Python's error message, with an explanation in plain words before it. */
export function explained(message: Phrase | string): string {
  const text = say(message);
  const meaning = MEANINGS[/^(\w+): /.exec(text)?.[1] ?? ""];
  return meaning ? t(meaning, { message: text }) : text.charAt(0).toLocaleUpperCase() + text.slice(1);
}
