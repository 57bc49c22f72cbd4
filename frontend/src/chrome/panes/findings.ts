/** The program's problems as a list for a person: one entry for one mistake. */

import type { Problem } from "../../messages";
import { said } from "../../sentences";

/** The same mistake, with each place where a view shows it. */
export interface Finding {
  readonly key: string;
  readonly message: string;
  readonly severity: Problem["severity"];
  readonly places: readonly Problem[];
}

/** Errors first, each group in the order in which the server found it. */
export function findings(problems: readonly Problem[]): readonly Finding[] {
  const found = new Map<string, Problem[]>();
  for (const problem of problems) {
    const key = keyOf(problem, found);
    found.set(key, [...(found.get(key) ?? []), problem]);
  }
  const entries = [...found].map(([key, places]) => finding(key, places));
  return [...of(entries, "error"), ...of(entries, "warning")];
}

/** A mistake without a block that a view shows twice is there twice. */
function keyOf({ code, message, block, view }: Problem, found: ReadonlyMap<string, readonly Problem[]>): string {
  const same = `${code}|${message}|${block ?? ""}`;
  const known = found.get(same)?.filter((one) => one.view === view).length ?? 0;
  return block || known === 0 ? same : `${same}|${found.size}`;
}

function finding(key: string, places: readonly Problem[]): Finding {
  const { message = "", severity = "error" } = places[0] ?? {};
  return { key, message: said(message), severity, places };
}

function of(entries: readonly Finding[], severity: Problem["severity"]): readonly Finding[] {
  return entries.filter((one) => one.severity === severity);
}
