/** Playing with a classmate in one world, for a pupil's page. */

import { signal } from "@preact/signals";

import type { Classmate, InPair } from "../../protocol/classroom";
import type { Connection } from "../../protocol/connection";

export class Pairs {
  /** With whom the pupil plays; null outside a class. */
  readonly now = signal<InPair | null>(null);
  /** Who can be invited; null until the class has answered. */
  readonly classmates = signal<readonly Classmate[] | null>(null);
  /** Whether a guest's page shows the host's world instead of its own. */
  readonly isAway = signal(false);

  constructor(private readonly connection: Connection) {
    connection.on("InPair", (news) => {
      const before = this.now.peek()?.state;
      this.now.value = news;
      if (news.state !== before) this.isAway.value = news.state === "guest";
    });
    connection.on("Classmates", ({ pupils = [] }) => (this.classmates.value = pupils));
  }

  /** Whether the pupil can invite a classmate. */
  get canInvite(): boolean {
    const { allowed = false, state = "alone" } = this.now.value ?? {};
    return allowed && state === "alone";
  }

  ask(): void {
    this.classmates.value = null;
    this.connection.send({ kind: "AskClassmates" });
  }

  invite(pupil: string): void {
    this.connection.send({ kind: "Invite", pupil });
  }

  answer(on: boolean): void {
    this.connection.send({ kind: "AnswerInvitation", on });
  }

  leave(): void {
    this.connection.send({ kind: "LeaveWorld" });
  }
}

declare module "../../model/page" {
  interface Page {
    readonly pairs: Pairs;
  }
}
