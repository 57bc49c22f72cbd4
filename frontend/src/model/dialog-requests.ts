/** The requests of a dialog, which shows itself why one was refused. */

import { type ReadonlySignal, signal } from "@preact/signals";

import { type Phrase, t } from "../i18n";
import type { Answer, Connection } from "../protocol/connection";
import type { FromPage } from "../protocol/messages";
import { readText } from "../ui/files";

export class DialogRequests {
  private readonly reason = signal<Phrase | string>("");
  /** Why the last request was refused, or could not be made; empty if it was not. */
  readonly refusal: ReadonlySignal<Phrase | string> = this.reason;

  constructor(private readonly connection: Connection) {}

  /** Send a request and return its answer; null if it was refused. */
  async ask(message: FromPage): Promise<Answer | null> {
    this.refuse("");
    const answer = await this.connection.ask(message);
    if (answer.kind !== "Failed") return answer;
    this.refuse(answer.message);
    return null;
  }

  /** Show a reason of the page's own; an empty one forgets the last. */
  refuse(reason: Phrase | string): void {
    this.reason.value = reason;
  }

  /** The text of a file; null and a reason if it is longer than the server accepts, or not UTF-8. */
  async textOf(file: File, longest: number, tooLong: string): Promise<string | null> {
    this.refuse(file.size > longest ? tooLong : "");
    if (file.size > longest) return null;
    const text = await readText(file);
    if (text === null) this.refuse(t("page-project-not-utf-8", { name: file.name }));
    return text;
  }
}
