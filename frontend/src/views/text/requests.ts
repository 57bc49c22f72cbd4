/** Requests to the server about a position in a text. */

import type { EditorState } from "@codemirror/state";
import { effect } from "@preact/signals";
import { language } from "../../i18n";
import type { Context } from "../../model/context";
import { shows } from "../../model/shown-blocks";
import type { Completion, Completions, Description, Notation } from "../../protocol/messages";

type Answered = Completions | Description;
interface Question {
  readonly request: number;
  answer(message: Answered | null): void;
}

/** Sends requests and resolves each with its answer; a newer request of a kind cancels the older one. */
export class Requests {
  private readonly open = new Map<Answered["kind"], Question>();
  private readonly disposers: (() => void)[];
  private last: number;

  constructor(
    private readonly context: Context,
    private readonly notation: Notation,
  ) {
    // Both texts share one connection: one uses even numbers, the other odd ones.
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

  /** Whether the palette shows the suggested block; true for suggestions that are not blocks. */
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
    this.last += 2;
    const request = this.last;
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
