/** Questions to the server about a place in a text. */

import { effect } from "@preact/signals";
import type { EditorState } from "@codemirror/state";

import { shows } from "../blocksets/rule";
import type { Context } from "../context";
import { language } from "../i18n";
import type { Completion, Completions, Description, Notation } from "../messages";

type Answered = Completions | Description;
interface Question {
  readonly request: number;
  answer(message: Answered | null): void;
}

/** Asks, and hands each answer to who asked; a newer question of a kind makes the older one vain. */
export class Requests {
  private readonly open = new Map<Answered["kind"], Question>();
  private readonly disposers: (() => void)[];
  private last: number;

  constructor(
    private readonly context: Context,
    private readonly notation: Notation,
  ) {
    // Both texts ask over one connection: one counts in even numbers, the other in odd ones.
    this.last = notation === "python" ? 1 : 0;
    const { connection } = context;
    this.disposers = [
      connection.on("Completions", (message) => this.answer(message)),
      connection.on("Description", (message) => this.answer(message)),
      effect(() => {
        if (connection.state.value === "lost") this.abandon();
      }),
    ];
  }

  complete(state: EditorState, position: number): Promise<Completions | null> {
    return this.ask("Complete", "Completions", state, position) as Promise<Completions | null>;
  }

  describe(state: EditorState, position: number): Promise<Description | null> {
    return this.ask("Describe", "Description", state, position) as Promise<Description | null>;
  }

  /** Whether the palette offers what is suggested, as far as it is a block. */
  isShown({ sort, category = "", label }: Completion): boolean {
    const name = label.split(".").at(-1);
    return sort !== "skill" || shows(this.context.shownBlocks.peek(), category, `function.${name}`);
  }

  destroy(): void {
    for (const dispose of this.disposers) dispose();
    this.abandon();
  }

  private ask(
    kind: "Complete" | "Describe",
    answer: Answered["kind"],
    state: EditorState,
    position: number,
  ): Promise<Answered | null> {
    this.open.get(answer)?.answer(null);
    const request = (this.last += 2);
    const line = state.doc.lineAt(position);
    const column = position - line.from + 1;
    this.context.program.flush();
    return new Promise((resolve) => {
      this.open.set(answer, { request, answer: resolve });
      const place = { notation: this.notation, line: line.number, column };
      const sent = this.context.connection.send({ kind, request, ...place, language: language.peek() });
      if (!sent) resolve(null);
    });
  }

  private answer(message: Answered): void {
    const question = this.open.get(message.kind);
    if (question?.request !== message.request) return;
    this.open.delete(message.kind);
    question.answer(message);
  }

  private abandon(): void {
    for (const question of this.open.values()) question.answer(null);
    this.open.clear();
  }
}
