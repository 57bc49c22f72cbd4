/** The program's output and questions, and the results of runs. */

import "./panel.css";
import "./console.css";

import { effect, untracked } from "@preact/signals";
import { language, say, t } from "../../i18n";
import type { Context } from "../../model/context";
import type { Answered } from "../../model/dialogue";
import { placeIn, placeText, warningsAtStart } from "../../model/findings";
import { explained } from "../../model/run-error";
import { endingAfter } from "../../model/run-result";
import { runTitle } from "../../model/run-title";
import type { Ended, RunShown } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { button, element } from "./elements";
import { Lines, type OwnLine } from "./lines";
import { createQuestion, type Question } from "./question";

export interface ConsoleIsland extends Island {
  /** Focus the input line while the program asks, else the output. */
  focus(): void;
  resize(): void;
}

/** Results that are not errors. */
const WELL = new Set(["finished", "stopped", "time limit"]);

function timeOfDay(then: Date): string {
  return new Intl.DateTimeFormat(language.value, { timeStyle: "medium" }).format(then);
}

/** How a run ended, in one line. */
function ending({ ended, message, time = 0 }: Ended): string {
  const known = endingAfter(ended, time);
  return message && !WELL.has(ended) ? `${known} ${explained(message)}` : known;
}

class Console implements ConsoleIsland {
  readonly dom = element("section", { class: "robot-panel console" });
  private readonly lines = new Lines((text, after) => this.context.askingWhy.aboutPrinted(text, after));
  private readonly question: Question;
  /** Whether the end of the program has been shown, while those of other robots go on. */
  private isDone = false;
  /** How many runs of this program the console has shown. */
  private runs = 0;
  private readonly cleanup: Cleanup;

  constructor(private readonly context: Context) {
    this.question = createQuestion(context.running.dialogue);
    const copy = button("tool", () => void this.copy());
    const clear = button("tool", () => this.lines.clear());
    this.dom.append(this.lines.dom, this.question.dom, element("div", { class: "tools" }, copy, clear));
    this.cleanup = new Cleanup(
      ...this.listen(),
      effect(() => this.showAnswer(context.running.dialogue.answered.value)),
      effect(() => this.lines.showUntil(context.running.printed.value)),
      effect(() => {
        copy.textContent = t("page-console-copy");
        clear.textContent = t("page-console-clear");
        this.lines.dom.setAttribute("aria-label", t("page-console-lines"));
        this.lines.dom.dataset.empty = t("page-console-empty");
        // Lines that are added later lead to this view, too.
        void context.openView.value;
        this.lines.translate();
      }),
    );
  }

  focus(): void {
    if (this.question.open) this.question.focus();
    else this.lines.dom.focus();
  }

  resize(): void {
    this.lines.follow();
  }

  destroy(): void {
    this.cleanup.dispose();
    this.lines.destroy();
    this.question.destroy();
  }

  private listen(): (() => void)[] {
    const { connection } = this.context;
    return [
      connection.on("Opened", () => this.begin()),
      connection.on("TabOpened", () => this.begin()),
      // These messages follow, and tell it whenever it changes.
      connection.on("TabOpened", ({ shows = "" }) => this.lines.show(shows)),
      connection.on("Tabs", ({ shows = "" }) => this.lines.show(shows)),
      connection.on("Printed", ({ text, until = 0 }) => this.lines.print({ robot: "", text, until })),
      connection.on("PrintedByRobots", ({ parts }) => parts.forEach((part) => this.lines.print(part))),
      connection.on("Bumped", ({ thing, time }) =>
        this.lines.add({
          words: () => t("page-console-bumped", { thing: say(thing), time: time.toFixed(1) }),
          sort: "bad",
        }),
      ),
      connection.on("RunShown", (shown) => this.showRun(shown)),
      connection.on("RunState", ({ state }) => {
        if (state === "starting") this.started();
      }),
      connection.on("Ended", (ended) => this.ended(ended)),
    ];
  }

  private started(): void {
    this.isDone = false;
    this.lines.beginRun();
    const [number, began] = [++this.runs, new Date()];
    this.lines.add({ words: () => t("page-console-run", { number, time: timeOfDay(began) }), sort: "run" });
    const { shown, more } = warningsAtStart(this.context);
    for (const { message, place } of shown) {
      const lead = { words: () => placeText(this.context, place), go: () => this.context.goTo(place) };
      this.lines.add({ words: () => t("page-console-warning", { message }), sort: "warned", lead });
    }
    if (more > 0) this.lines.add({ words: () => t("page-console-more-warnings", { count: more }), sort: "warned" });
  }

  /** A program that ends before those of other robots is reported again with the whole run. */
  private ended(ended: Ended): void {
    if (!this.isDone) this.lines.add({ words: () => ending(ended), isEnd: true, ...this.described(ended) });
    this.isDone = ended.others ?? false;
  }

  /** How the end is shown; an error leads to where it happened, in the view that is open. */
  private described({ ended }: Ended): Pick<OwnLine, "sort" | "lead"> {
    if (WELL.has(ended)) return { sort: "good" };
    const { runError, openView } = this.context;
    const places = runError.peek();
    const place = () => placeIn(places, openView.value);
    const words = () => {
      const shown = place();
      return shown ? placeText(this.context, shown) : "";
    };
    const go = () => {
      const shown = place();
      if (shown) this.context.goTo(shown);
    };
    return { sort: "bad", lead: { words, go } };
  }

  /** Show what a kept run has printed, or the newest one again. */
  private showRun({ run, printed = "" }: RunShown): void {
    this.begin();
    if (run) this.lines.add({ words: () => t("page-runs-console", { name: runTitle(run) }), sort: "run" });
    this.lines.beginRun();
    if (printed) this.lines.print({ robot: "", text: printed, until: printed.length });
  }

  /** Start with an empty console whenever another program is shown. */
  private begin(): void {
    this.isDone = false;
    this.runs = 0;
    this.lines.clear();
  }

  private showAnswer(answered: Answered | null): void {
    if (!answered) return;
    const line = `${(answered.prompt || t("page-console-asks")).trim()} ${answered.text}`;
    untracked(() => this.lines.add({ words: () => line, sort: "asked" }));
  }

  private async copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.lines.text());
    } catch {
      // Over plain HTTP from another computer there is no clipboard: select the text instead.
      getSelection()?.selectAllChildren(this.lines.dom);
    }
  }
}

/** The console: output, input line, and results of runs. */
export function createConsole(context: Context): ConsoleIsland {
  return new Console(context);
}
