/** The program's problems as a list, with one entry for each mistake. */

import { say } from "../i18n";
import type { Problem, View } from "../protocol/messages";
import type { Context } from "./context";

/** More warnings would hide what the program prints. */
const MOST_AT_START = 3;

/** One mistake, with its positions in all views. */
export interface Finding {
  readonly key: string;
  readonly message: string;
  readonly severity: Problem["severity"];
  readonly places: readonly Problem[];
}

/** Errors first, then warnings, each in the server's order, in the words of the view that was edited last. */
export function findings(problems: readonly Problem[], origin: View): readonly Finding[] {
  const found = new Map<string, Problem[]>();
  for (const problem of problems) {
    const key = keyOf(problem, found);
    found.set(key, [...(found.get(key) ?? []), problem]);
  }
  const entries = [...found].map(([key, places]) => finding(key, places, origin));
  return [...of(entries, "error"), ...of(entries, "warning")];
}

/** The number of problems, the error of the last run among them, and whether any of them is an error. */
export function countProblems({ program, running }: Context): { count: number; serious: boolean } {
  const { problems, origin } = program.state.value;
  const found = findings(problems, origin);
  const failed = running.ended.value?.ended === "error";
  return {
    count: found.length + (failed ? 1 : 0),
    serious: failed || found.some((one) => one.severity === "error"),
  };
}

/** The warnings that a run begins with: the first few, and how many more there are. */
export function warningsAtStart({ program }: Context): { shown: readonly Finding[]; more: number } {
  const { problems, origin } = program.state.value;
  const found = of(findings(problems, origin), "warning");
  return { shown: found.slice(0, MOST_AT_START), more: Math.max(0, found.length - MOST_AT_START) };
}

/** If one view shows a mistake twice and it belongs to no block, it counts as two mistakes. */
function keyOf({ code, message, block, view }: Problem, found: ReadonlyMap<string, readonly Problem[]>): string {
  const same = `${code}|${say(message)}|${block ?? ""}`;
  const known = found.get(same)?.filter((one) => one.view === view).length ?? 0;
  return block || known === 0 ? same : `${same}|${found.size}`;
}

function finding(key: string, places: readonly Problem[], origin: View): Finding {
  const { message, in_blocks, severity = "error" } = places[0] ?? {};
  const words = origin === "blocks" ? (in_blocks ?? message) : message;
  return { key, message: words ? say(words) : "", severity, places };
}

function of(entries: readonly Finding[], severity: Problem["severity"]): readonly Finding[] {
  return entries.filter((one) => one.severity === severity);
}
