/** The error that the last run ended with, where each view shows it. */

import { computed, type ReadonlySignal } from "@preact/signals";

import { translated } from "./i18n";
import type { Ended, Place, Problem, View } from "./messages";
import type { Program } from "./program";
import type { Running } from "./running";
import { said } from "./sentences";

/** A problem for each view; none once the program has been changed, for that may have mended it. */
export function runError(program: Program, running: Running): ReadonlySignal<readonly Problem[]> {
  const ran = computed(() => running.ended.value && program.state.peek().python);
  return computed(() => {
    const { python, places } = program.state.value;
    const ended = running.ended.value;
    return ended?.ended === "error" && ran.value === python ? problemsOf(ended, places) : [];
  });
}

function problemsOf(ended: Ended, places: readonly Place[]): readonly Problem[] {
  const place = places.find(([block]) => block === ended.block);
  if (!place) return [];
  const [block, blocktext, , python] = place;
  const shared = { code: "run", message: explained(ended.message ?? ""), severity: "error", block } as const;
  const inText = (view: View, line: number) => (line > 0 ? [{ ...shared, view, line }] : []);
  return [{ ...shared, view: "blocks" }, ...inText("blocktext", blocktext), ...inText("python", python)];
}

/** What Python says of an error, and before that what it means for those who do not know Python's words. */
export function explained(message: string): string {
  const name = /^(\w+): /.exec(message)?.[1] ?? "";
  const meaning = translated(`problems.run_${name}`, "");
  if (meaning) return `${meaning.replace(/\.$/, "")} (${message}).`;
  const told = said(message);
  return told.charAt(0).toLocaleUpperCase() + told.slice(1);
}
