/** What a running program says to its user, and asks. */

import { batch, signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";

/** A question of the program, and the user's answer. */
export interface Answered {
  readonly prompt: string;
  readonly text: string;
}

export class Dialogue {
  /** The last line that the run has printed; empty if it has printed none. */
  readonly said = signal("");
  /** The question that waits for an answer; null if there is none. */
  readonly asked = signal<string | null>(null);
  /** The last question with its answer; null before there is one. */
  readonly answered = signal<Answered | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("Printed", ({ text }) => this.say(text));
    connection.on("PrintedByRobots", ({ parts }) => parts.forEach(({ text }) => this.say(text)));
    connection.on("InputWanted", ({ prompt }) => (this.asked.value = prompt));
    connection.on("Ended", () => (this.asked.value = null));
  }

  /** Forget it all, for another run or program. */
  reset(): void {
    batch(() => {
      this.said.value = "";
      this.asked.value = this.answered.value = null;
    });
  }

  answer(text: string): void {
    const prompt = this.asked.peek();
    if (prompt === null) return;
    batch(() => {
      this.asked.value = null;
      this.answered.value = { prompt, text };
    });
    this.connection.send({ kind: "Answer", text });
  }

  private say(text: string): void {
    const line = text.trimEnd().split("\n").at(-1)?.trim();
    if (line) this.said.value = line;
  }
}
