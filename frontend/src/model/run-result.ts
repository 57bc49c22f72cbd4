/** The result of a run in words. */

import { t } from "../i18n";
import type { Ended, GoalNow } from "../protocol/messages";
import { explained } from "./run-error";

const KNOWN = new Set(["finished", "error", "time limit", "stopped", "no call", "output limit", "killed"]);

/** How it ended, in one or two words. */
export function ending(ended: string): string {
  return KNOWN.has(ended) ? t(`page-problems-ended-${ended.replace(" ", "-")}`) : ended;
}

/** How it ended, and after how many seconds. */
export function endingAfter(ended: string, time: number): string {
  return t(`page-console-${ended.replace(" ", "-")}`, { seconds: Math.round(time * 10) / 10 });
}

/** The run in one sentence. */
export function sentence({ ended, message, goals = [], time = 0 }: Ended): string {
  const parts = [endingAfter(ended, time)];
  if (message) parts.push(explained(message));
  if (goals.length > 0) {
    parts.push(t("page-problems-goals-reached", { reached: reachedOf(goals), all: goals.length }));
  }
  return parts.map((part) => (/[.!?]$/.test(part) ? part : `${part}.`)).join(" ");
}

function reachedOf(goals: readonly GoalNow[]): number {
  return goals.filter((goal) => goal.state === "reached").length;
}
