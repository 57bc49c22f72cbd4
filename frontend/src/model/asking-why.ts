/** Questions about the run, and the answer to the one that was asked last. */

import { signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { Asked, GoalNow, TimeMark, WhyAnswer, WhyQuestion } from "../protocol/messages";
import type { Running } from "./running";

/** The kinds of questions about what the timeline marks; there is none about a robot placed by hand. */
const OF_MARKS: Readonly<Partial<Record<TimeMark["sort"], WhyQuestion["ask"]>>> = {
  bump: "bump",
  print: "printed",
  emotion: "emotion",
  when: "when",
  error: "end",
};

export class AskingWhy {
  /** What can be asked; null until the server has told it. */
  readonly questions = signal<readonly Asked[] | null>(null);
  readonly answer = signal<WhyAnswer | null>(null);
  /** Whether the user has asked something in this run, or its questions have been read. */
  isUsed = false;
  /** Whether nothing can be asked: a guest sees the run of another pupil. */
  isOff = false;
  /** Whether the questions are those about the run, rather than about a block or a moment. */
  private isWholeRun = false;
  /** Whether the questions are only those about the robot at one moment. */
  readonly isAboutMoment = signal(false);

  constructor(
    private readonly connection: Connection,
    private readonly running: Running,
    /** Shows the questions and the answer. */
    private readonly show: () => void,
  ) {
    connection.on("Questions", ({ questions, block }) => {
      this.questions.value = questions;
      const [only] = questions;
      if (block && only && questions.length === 1) this.ask(only.question);
    });
    connection.on("WhyAnswer", (answer) => (this.answer.value = answer));
    connection.on("RunState", ({ state }) => {
      if (state === "starting" || state === "idle") this.forget();
      // What could be asked when the list was read is not all that can be asked now.
      if ((state === "paused" || state === "held") && this.isWholeRun && !this.answer.value) this.read();
    });
    connection.on("RunShown", () => this.forget());
  }

  private forget(): void {
    this.questions.value = this.answer.value = null;
    this.isUsed = this.isWholeRun = false;
  }

  /** Whether there is a run to ask about. */
  get isPossible(): boolean {
    return !this.isOff && (!!this.running.timeline.value?.end || this.running.active.value);
  }

  /** Read what can be asked about the run. */
  read(): void {
    this.isUsed = this.isWholeRun = true;
    this.answer.value = null;
    this.isAboutMoment.value = false;
    this.connection.send({ kind: "ReadQuestions" });
  }

  ask(question: WhyQuestion): void {
    this.isUsed = true;
    this.show();
    this.connection.send({ kind: "AskWhy", question });
  }

  /** Ask why a block ran, or why it did not; if both can be asked, offer both. */
  aboutBlock(block: string): void {
    this.isUsed = true;
    this.answer.value = null;
    this.isAboutMoment.value = this.isWholeRun = false;
    this.show();
    this.connection.send({ kind: "ReadQuestions", block, time: this.time });
  }

  /** Ask what the robot is doing, and offer what else can be asked about this moment. */
  aboutRobot(): void {
    const time = this.time ?? this.running.timeline.peek()?.end ?? this.running.telemetry.peek()?.time ?? 0;
    this.isAboutMoment.value = true;
    this.isWholeRun = false;
    this.connection.send({ kind: "ReadQuestions", time });
    this.ask({ ask: "now", subject: "", time });
  }

  aboutVariable(name: string): void {
    this.ask({ ask: "value", subject: name, time: this.time });
  }

  aboutWhen(name: string, isActive: boolean): void {
    this.ask({ ask: isActive ? "when" : "not-when", subject: name, time: this.time });
  }

  aboutGoal({ name, state }: Pick<GoalNow, "name" | "state">): void {
    this.ask({ ask: state === "reached" ? "reached" : "goal", subject: name, time: this.time });
  }

  /** Ask why a check of a lesson failed. */
  aboutCheck(ask: "now" | "goal" | "bump", subject: string): void {
    if (ask === "now") this.aboutRobot();
    else this.ask({ ask, subject, time: null });
  }

  /**
   * Ask why a text was printed.
   *
   * @param after how many texts this run has printed since.
   */
  aboutPrinted(text: string, after: number): void {
    // While the program runs, the timeline may lack the newest texts.
    const marks = this.running.active.peek() ? [] : (this.running.timeline.peek()?.marks ?? []);
    const mark = marks.filter(({ sort }) => sort === "print").at(-1 - after);
    this.ask({ ask: "printed", subject: text, time: mark?.text === text ? mark.time : null });
  }

  /** Ask about what the timeline marks. */
  aboutMark({ sort, text, time }: TimeMark): void {
    if (sort === "goal") {
      const [, name = text, state = ""] = /^(.*): (\w+)$/.exec(text) ?? [];
      this.ask({ ask: state === "reached" ? "reached" : "goal", subject: name, time });
      return;
    }
    const ask = OF_MARKS[sort];
    if (ask) this.ask({ ask, subject: ask === "end" ? "" : text, time });
    else this.aboutRobot();
  }

  /** The moment that is looked back at; null for the present. */
  private get time(): number | null {
    return this.running.past.peek()?.time ?? null;
  }
}
