/** Announces events to screen readers. */

import { effect, signal } from "@preact/signals";
import { t, worldName } from "../i18n";
import type { Ended, RobotLink, RunState, Telemetry } from "../protocol/messages";
import type { Context } from "./context";
import { sentence } from "./run-result";
import { stateInWords } from "./running";

/** Waits before announcing errors, so typing a line does not announce each half-typed state. */
const QUIET = 1500;

/** The texts of the two live regions: `polite` waits for a pause, `assertive` does not. */
export class Announcer {
  readonly polite = signal("");
  readonly assertive = signal("");
  private reached = new Set<string>();
  private errors = 0;
  /** Whether this page has seen the run: opening a project tells how its last one ended. */
  private isFollowing = false;
  private linked: RobotLink["state"] = "simulated";

  constructor(private readonly context: Context) {
    const { connection } = context;
    connection.on("RunState", (state) => this.runState(state));
    connection.on("Telemetry", (telemetry) => this.goals(telemetry));
    connection.on("RobotLink", (link) => this.link(link));
    connection.on("Ended", (ended) => this.ended(ended));
    effect(() => this.countErrors());
  }

  say(text: string): void {
    // A live region ignores the same text twice: a space makes it different.
    this.polite.value = text === this.polite.value ? `${text} ` : text;
  }

  private runState(run: RunState): void {
    const { state } = run;
    if (state === "starting") this.reached.clear();
    if (state !== "ended") this.isFollowing = state !== "idle";
    if (state !== "ended" && state !== "idle") this.say(stateInWords(run));
  }

  private goals({ goals = [] }: Telemetry): void {
    const reached = goals.filter((goal) => goal.state === "reached" && !this.reached.has(goal.name));
    for (const goal of reached) this.reached.add(goal.name);
    if (reached.length > 0) {
      this.say(t("page-shell-goal-reached", { goal: reached.map((goal) => worldName(goal.name)).join(", ") }));
    }
  }

  private link({ state }: RobotLink): void {
    if (state === this.linked) return;
    this.linked = state;
    if (state === "weak") this.say(t("page-link-weak-said"));
    if (state === "lost") this.assertive.value = t("page-link-lost-said");
  }

  private ended(ended: Ended): void {
    if (!this.isFollowing) return;
    this.isFollowing = false;
    if (ended.ended === "error") this.assertive.value = sentence(ended);
    else this.say(sentence(ended));
  }

  /** Announce the number of errors once it has been stable for a while. */
  private countErrors(): () => void {
    const count = this.context.program.state.value.problems.filter((problem) => problem.severity === "error").length;
    const timer = setTimeout(() => {
      if (count !== this.errors) this.say(t(count ? "page-problems-some" : "page-problems-none", { count }));
      this.errors = count;
    }, QUIET);
    return () => clearTimeout(timer);
  }
}
