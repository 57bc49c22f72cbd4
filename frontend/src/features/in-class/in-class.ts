/** What happens in the class, for a page that shows a pupil's program. */

import { signal } from "@preact/signals";

import type { InClass } from "../../protocol/classroom";
import type { Connection } from "../../protocol/connection";

export class ClassNews {
  /** The newest news; null outside a class. */
  readonly now = signal<InClass | null>(null);
  /** The number of the hint that the pupil has put away. */
  readonly read = signal(0);

  constructor(private readonly connection: Connection) {
    connection.on("InClass", (news) => {
      this.now.value = news;
    });
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
