/** What happens in the class, for a page that shows a pupil's program. */

import { signal } from "@preact/signals";

import type { InClass } from "../../protocol/classroom";
import type { Connection } from "../../protocol/connection";

/** ms between two questions to the class; two without an answer mean that it doesn't answer. */
export const PERIOD = 4000;

export class ClassNews {
  /** The newest news; null outside a class. */
  readonly now = signal<InClass | null>(null);
  /** The number of the hint that the pupil has put away. */
  readonly read = signal(0);

  /** Whether the class does not answer, although the connection is there: its computer may be asleep. */
  readonly silent = signal(false);
  /** The questions for news since the last answer. */
  private asked = 0;

  constructor(private readonly connection: Connection) {
    connection.on("InClass", (news) => {
      if (!this.now.peek()) setInterval(() => this.listen(), PERIOD);
      this.asked = 0;
      this.silent.value = false;
      this.now.value = news;
    });
    connection.state.subscribe(() => {
      this.asked = 0;
      this.silent.value = false;
    });
  }

  /** Ask for news, to see whether the class still answers. */
  private listen(): void {
    this.silent.value = this.asked > 1;
    if (this.connection.send({ kind: "AskNews" })) this.asked++;
  }

  /** Raise the hand, with or without a question, or lower it. */
  askForHelp(on: boolean, question = ""): void {
    this.connection.send({ kind: "AskForHelp", on, question });
  }

  /** Let the teacher write, or no more. */
  letTeacherWrite(on: boolean): void {
    this.connection.send({ kind: "LetTeacherWrite", on });
  }

  /** As the teacher: ask the pupil to be allowed to write, or stop writing. */
  askToWrite(on: boolean): void {
    this.connection.send({ kind: "AskToWrite", on });
  }

  /** Put the teacher's hint away. */
  putAway(): void {
    this.read.value = this.now.peek()?.hints ?? 0;
  }
}

declare module "../../model/page" {
  interface Page {
    readonly classNews: ClassNews;
  }
}
