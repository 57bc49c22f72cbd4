/** A run's end in words. */

import { t } from "../i18n";
import type { Ended, GoalNow } from "../messages";
import { explained } from "../runerror";

const KNOWN = new Set(["finished", "error", "time limit", "stopped", "no call", "output limit", "killed"]);

/** How it ended, in one word or two. */
export function ending(ended: string): string {
  return KNOWN.has(ended) ? t(`problems.ended_${ended.replace(" ", "_")}`) : ended;
}

/** The run in one sentence. */
export function sentence({ ended, message = "", goals = [], time = 0 }: Ended): string {
  const parts = [t("problems.endedAfter", { how: ending(ended), seconds: time.toFixed(1) })];
  if (message) parts.push(explained(message));
  if (goals.length > 0) {
    parts.push(t("problems.goalsReached", { reached: reachedOf(goals), all: goals.length }));
  }
  return parts.map((part) => (/[.!?]$/.test(part) ? part : `${part}.`)).join(" ");
}

function reachedOf(goals: readonly GoalNow[]): number {
  return goals.filter((goal) => goal.state === "reached").length;
}
