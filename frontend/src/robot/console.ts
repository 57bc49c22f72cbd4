/** What the program prints and asks, and how its runs end. */

import "./panel.css";
import "./console.css";

import { effect } from "@preact/signals";

import type { Context } from "../context";
import { t } from "../i18n";
import type { Island } from "../island";
import type { Ended } from "../messages";
import { explained } from "../runerror";
import { button, element } from "./elements";
import { Lines } from "./lines";
import { createQuestion, type Question } from "./question";

export interface ConsoleIsland extends Island {
  /** To where one answers while the program asks, else to what it has printed. */
  focus(): void;
  resize(): void;
}

/** Endings after which nothing is wrong. */
const WELL = new Set(["finished", "stopped", "time limit"]);

/** How a run ended, in one line. */
function ending({ ended, message, time }: Ended): string {
  const seconds = (time ?? 0).toFixed(1);
  const known = t(`console.${ended.replace(/ (\w)/g, (_, letter: string) => letter.toUpperCase())}`, { seconds });
  return message && !WELL.has(ended) ? `${known} ${explained(message)}` : known;
}

class Console implements ConsoleIsland {
  readonly dom = element("section", { class: "robot-panel console" });
  private readonly lines = new Lines();
  private readonly question: Question;
  private readonly disposers: (() => void)[];

  constructor(private readonly context: Context) {
    this.question = createQuestion((text) => this.answer(text));
    const copy = button("tool", () => void this.copy());
    const clear = button("tool", () => this.lines.clear());
    this.dom.append(this.lines.dom, this.question.dom, element("div", { class: "tools" }, copy, clear));
    this.disposers = [
      ...this.listen(),
      effect(() => {
        copy.textContent = t("console.copy");
        clear.textContent = t("console.clear");
        this.lines.dom.setAttribute("aria-label", t("console.lines"));
      }),
    ];
  }

  focus(): void {
    if (this.question.open) this.question.focus();
    else this.lines.dom.focus();
  }

  resize(): void {
    this.lines.follow();
  }

  destroy(): void {
    for (const dispose of this.disposers) dispose();
    this.lines.destroy();
    this.question.destroy();
  }

  private listen(): (() => void)[] {
    const { connection } = this.context;
    return [
      connection.on("Opened", () => this.begin()),
      connection.on("Printed", ({ text }) => this.lines.print(text)),
      connection.on("InputWanted", ({ prompt }) => this.question.ask(prompt || t("console.asks"))),
      connection.on("RunState", ({ state }) => {
        if (state === "starting") this.lines.add(t("console.started"), "note");
      }),
      connection.on("Ended", (ended) => {
        this.question.close();
        this.lines.add(ending(ended), WELL.has(ended.ended) ? "good" : "bad");
      }),
    ];
  }

  /** What belongs to the project is told anew whenever one is opened. */
  private begin(): void {
    this.question.close();
    this.lines.clear();
  }

  private answer(text: string): void {
    this.lines.add(`${this.question.prompt} ${text}`, "asked");
    this.context.connection.send({ kind: "Answer", text });
  }

  private async copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.lines.text());
    } catch {
      // Not over plain HTTP from another computer: the text is marked for the user to copy.
      getSelection()?.selectAllChildren(this.lines.dom);
    }
  }
}

/** The console: what was printed, a line to answer in, and how runs ended. */
export function createConsole(context: Context): ConsoleIsland {
  return new Console(context);
}
