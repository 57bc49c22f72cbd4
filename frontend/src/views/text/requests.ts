/** Requests to the server about a position in a text. */

import type { EditorState } from "@codemirror/state";
import { language } from "../../i18n";
import type { Context } from "../../model/context";
import { shows } from "../../model/shown-blocks";
import type { Completion, Completions, Description, Notation } from "../../protocol/messages";

type Question = "Complete" | "Describe";

/** Sends requests and resolves each with its answer; a newer request of a kind cancels the older one. */
export class Requests {
  private readonly newest = new Map<Question, symbol>();

  constructor(
    private readonly context: Context,
    private readonly notation: Notation,
  ) {}

  async complete(state: EditorState, position: number): Promise<Completions | null> {
    const answer = await this.ask("Complete", state, position);
    return answer?.kind === "Completions" ? answer : null;
  }

  async describe(state: EditorState, position: number): Promise<Description | null> {
    const answer = await this.ask("Describe", state, position);
    return answer?.kind === "Description" ? answer : null;
  }

  /** Whether the palette shows the suggested block; true for suggestions that are not blocks. */
  isShown({ sort, category = "", label }: Completion): boolean {
    const name = label.split(".").at(-1);
    return sort !== "skill" || shows(this.context.shownBlocks.peek(), category, `function.${name}`);
  }

  /** The answers that are still to come are of no use any more. */
  destroy(): void {
    this.newest.clear();
  }

  private async ask(kind: Question, state: EditorState, position: number) {
    const question = Symbol(kind);
    this.newest.set(kind, question);
    const line = state.doc.lineAt(position);
    const place = { notation: this.notation, line: line.number, column: position - line.from + 1 };
    const { program, connection } = this.context;
    program.flush();
    const answer = await connection.ask({ kind, ...place, language: language.peek() });
    return this.newest.get(kind) === question ? answer : null;
  }
}
