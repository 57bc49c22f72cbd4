/** Showing programs to the teacher and to classmates, for a pupil's page. */

import { signal } from "@preact/signals";

import type { Classmate, ProgramOffers } from "../../protocol/classroom";
import type { Connection } from "../../protocol/connection";

export class ShownPrograms {
  /** What classmates show; null outside a class. */
  readonly now = signal<ProgramOffers | null>(null);
  /** To whom a program can be shown; null until the class has answered. */
  readonly viewers = signal<readonly Classmate[] | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("ProgramOffers", (news) => (this.now.value = news));
    connection.on("Classmates", ({ pupils = [] }) => (this.viewers.value = pupils));
  }

  showTeacher(): void {
    this.connection.send({ kind: "ShowTeacher" });
  }

  ask(): void {
    this.viewers.value = null;
    this.connection.send({ kind: "AskViewers" });
  }

  show(pupil: string, link: string): void {
    this.connection.send({ kind: "ShowClassmate", pupil, link });
  }

  answer(pupil: string, on: boolean): void {
    this.connection.send({ kind: "AnswerOffer", pupil, on });
  }
}

declare module "../../model/page" {
  interface Page {
    readonly shownPrograms: ShownPrograms;
  }
}
