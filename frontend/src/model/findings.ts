/** The program's mistakes as a list: each once, as the view that is open shows it. */

import { say, t } from "../i18n";
import type { Problem, View } from "../protocol/messages";
import type { Context } from "./context";

/** More warnings would hide what the program prints. */
const MOST_AT_START = 3;

/** One mistake, where the open view shows it. */
export interface Finding {
  readonly key: string;
  readonly message: string;
  readonly severity: Problem["severity"];
  readonly place: Problem;
}

/** Errors first, then warnings, each in the server's order. */
export function findings(problems: readonly Problem[], open: View, origin: View): readonly Finding[] {
  const found = new Map<string, Problem>();
  // Another view adds only what those before it do not have.
  for (const view of new Set<View>([open, origin, "blocktext", "python", "blocks"])) {
    for (const [key, problem] of keyed(problems, view)) if (!found.has(key)) found.set(key, problem);
  }
  const entries = [...found].map(([key, problem]) => finding(key, problem, open));
  return [...of(entries, "error"), ...of(entries, "warning")];
}

/** The number of problems, the error of the last run among them, and whether any of them is an error. */
export function countProblems(context: Context): { count: number; serious: boolean } {
  const found = findingsOf(context);
  const failed = context.running.ended.value?.ended === "error";
  return {
    count: found.length + (failed ? 1 : 0),
    serious: failed || found.some((one) => one.severity === "error"),
  };
}

/** The mistakes of the program as it is. */
export function findingsOf({ program, openView }: Context): readonly Finding[] {
  const { problems, origin } = program.state.value;
  return findings(problems, openView.value, origin);
}

/** The warnings that a run begins with: the first few, and how many more there are. */
export function warningsAtStart(context: Context): { shown: readonly Finding[]; more: number } {
  const found = of(findingsOf(context), "warning");
  return { shown: found.slice(0, MOST_AT_START), more: Math.max(0, found.length - MOST_AT_START) };
}

/** The problem of a view, or where that view does not have it, of another one. */
export function placeIn(places: readonly Problem[], open: View): Problem | undefined {
  return places.find(({ view }) => view === open) ?? places[0];
}

/** Where a problem is in its view: the line of a text, or the block in its own words. */
export function placeText({ describeStep }: Pick<Context, "describeStep">, { view, line = 0, block }: Problem): string {
  const name = t(`page-shell-${view}`);
  const step = view === "blocks" && block ? describeStep(view, block) : "";
  if (step) return t("page-problems-block", { step });
  return line > 0 ? t("page-problems-place", { view: name, line }) : name;
}

/** The problems of a view; the n-th of a kind in a block is one mistake with the n-th in another view. */
function keyed(problems: readonly Problem[], shown: View): [string, Problem][] {
  const counts = new Map<string, number>();
  return problems
    .filter(({ view }) => view === shown)
    .map((problem) => {
      const kind = `${problem.code}|${problem.block ?? ""}`;
      const count = (counts.get(kind) ?? 0) + 1;
      counts.set(kind, count);
      return [`${kind}|${count}`, problem];
    });
}

function finding(key: string, problem: Problem, open: View): Finding {
  const { message, in_blocks, block, severity = "error" } = problem;
  const isBlock = open === "blocks" && block;
  const place: Problem = isBlock ? { ...problem, view: "blocks", line: 0, column: 0 } : problem;
  return { key, message: say((isBlock && in_blocks) || message), severity, place };
}

function of(entries: readonly Finding[], severity: Problem["severity"]): readonly Finding[] {
  return entries.filter((one) => one.severity === severity);
}
