/** Takes the place of the connection to a server: the recording answers at once. */

import { Connection } from "../../protocol/connection";
import type { FromPage, ToPage } from "../../protocol/messages";
import type { RecordedRun } from "./recorded";

export class RecordedConnection extends Connection {
  constructor(private run: RecordedRun) {
    super(new URL("ws://localhost/"), "");
    this.state.value = "open";
  }

  override open(): void {
    // There is nothing to connect to.
  }

  override send(message: Parameters<Connection["send"]>[0]): boolean {
    const answer = this.answer(message as FromPage);
    // As from a server: after the one who asks has done so.
    if (answer) queueMicrotask(() => this.received(answer));
    return true;
  }

  /** Let another run answer from now on. */
  follow(run: RecordedRun): void {
    this.run = run;
  }

  /** Take a message as if a server had sent it. */
  show(message: ToPage): void {
    this.received(message);
  }

  private answer(message: FromPage): ToPage | null {
    if (message.kind === "LookBack") return this.run.past(message);
    if (message.kind === "ReadQuestions") return this.run.questions(message);
    if (message.kind === "AskWhy") return this.run.answer(message);
    return null;
  }
}
