/** Tells a screen reader what happens. */

import { effect, signal } from "@preact/signals";

import type { Context } from "../../context";
import { t } from "../../i18n";
import type { Ended, RunState, Telemetry } from "../../messages";
import { said } from "../../sentences";
import { sentence } from "../result";

/** Somebody who types is not interrupted by each half-written line's errors. */
const QUIET = 1500;

/** What the two live regions say: `polite` waits for a pause, `assertive` does not. */
export class Announcer {
  readonly polite = signal("");
  readonly assertive = signal("");
  private reached = new Set<string>();
  private errors = 0;

  constructor(private readonly context: Context) {
    const { connection } = context;
    connection.on("RunState", (state) => this.runState(state));
    connection.on("Telemetry", (telemetry) => this.goals(telemetry));
    connection.on("Ended", (ended) => this.ended(ended));
    effect(() => this.countErrors());
  }

  say(text: string): void {
    // The same words again are no change to a live region: a space makes them one.
    this.polite.value = text === this.polite.value ? `${text} ` : text;
  }

  private runState({ state }: RunState): void {
    if (state === "starting") this.reached.clear();
    if (state !== "ended" && state !== "idle") this.say(t(`bar.state_${state}`));
  }

  private goals({ goals = [] }: Telemetry): void {
    const reached = goals.filter((goal) => goal.state === "reached" && !this.reached.has(goal.name));
    for (const goal of reached) this.reached.add(goal.name);
    if (reached.length > 0) {
      this.say(t("chrome.goalReached", { goal: reached.map((goal) => said(goal.name)).join(", ") }));
    }
  }

  private ended(ended: Ended): void {
    if (ended.ended === "error") this.assertive.value = sentence(ended);
    else this.say(sentence(ended));
  }

  /** Say how many errors there are once that has been so for a while. */
  private countErrors(): () => void {
    const count = this.context.program.state.value.problems.filter(
      (problem) => problem.severity === "error",
    ).length;
    const timer = setTimeout(() => {
      if (count !== this.errors) this.say(t(count ? "problems.some" : "problems.none", { count }));
      this.errors = count;
    }, QUIET);
    return () => clearTimeout(timer);
  }
}
