/** What a child does to come into the class. */

import { signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import type { AboutClass, Joined, NotJoined, Picture } from "../../protocol/classroom";

/** The pictures of a PIN. */
export const LENGTH = 4;

export class Joining {
  readonly about = signal<AboutClass | null>(null);
  readonly word = signal("");
  readonly name = signal("");
  readonly pictures = signal<readonly Picture[]>([]);
  readonly problem = signal<Phrase | null>(null);
  /** What a new pupil has to remember, and where to go on. */
  readonly joined = signal<Joined | null>(null);

  async load(): Promise<void> {
    this.about.value = (await (await fetch("about.json")).json()) as AboutClass;
  }

  /** Add a picture to the PIN; the fourth one sends it. */
  async add(picture: Picture): Promise<void> {
    if (this.pictures.peek().length >= LENGTH) return;
    this.pictures.value = [...this.pictures.peek(), picture];
    if (this.pictures.peek().length === LENGTH) await this.join(this.pictures.peek());
  }

  /** Take the last picture away. */
  back(): void {
    this.pictures.value = this.pictures.peek().slice(0, -1);
  }

  /** Come in; `null` for a pupil who is new. */
  async join(pictures: readonly Picture[] | null): Promise<void> {
    this.problem.value = null;
    const body = JSON.stringify({ word: this.word.peek(), name: this.name.peek(), pictures });
    const answer = await fetch("join", { method: "POST", body });
    if (!answer.ok) {
      this.problem.value = ((await answer.json()) as NotJoined).message;
      this.pictures.value = [];
      return;
    }
    const joined = (await answer.json()) as Joined;
    if (joined.pictures) this.joined.value = joined;
    else location.assign(joined.address);
  }

  /** Let another child use this device. */
  async leave(): Promise<void> {
    await fetch("leave", { method: "POST" });
    await this.load();
  }
}
