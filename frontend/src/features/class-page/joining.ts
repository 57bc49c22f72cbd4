/** What a child does to come into the class. */

import { computed, signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import type { AboutClass, Join, Joined, NotJoined, Picture, TryWord } from "../../protocol/classroom";

/** The pictures of a PIN. */
export const LENGTH = 4;

/** What is still to be typed or chosen. */
export type Missing = "word" | "name" | "whether" | "pictures";

/** Where to put right what the class has refused. */
const WRONG: Readonly<Record<string, Missing>> = {
  "class-wrong-word": "word",
  "class-no-name": "name",
  "class-hidden-character": "name",
  "class-only-first-name": "name",
  "class-name-taken": "name",
  "class-wrong-pictures": "pictures",
};

export class Joining {
  readonly about = signal<AboutClass | null>(null);
  readonly word = signal("");
  readonly name = signal("");
  /** Whether the child is new here; null until it has said so. */
  readonly isNew = signal<boolean | null>(null);
  readonly pictures = signal<readonly Picture[]>([]);
  readonly problem = signal<Phrase | null>(null);
  /** What a new pupil has to remember, and where to go on. */
  readonly joined = signal<Joined | null>(null);
  /** The word that the class has recognised. */
  private readonly known = signal<string | null>(null);

  readonly isKnownWord = computed(() => this.word.value !== "" && this.word.value === this.known.value);
  /** What the problem is about. */
  readonly wrong = computed(() => this.problem.value && (WRONG[this.problem.value.code] ?? null));
  /** What comes next; null once nothing is missing. */
  readonly missing = computed<Missing | null>(() => {
    if (!this.word.value.trim()) return "word";
    if (!this.name.value.trim()) return "name";
    if (this.isNew.value === null) return "whether";
    return !this.isNew.value && this.pictures.value.length < LENGTH ? "pictures" : null;
  });

  /** @param word the join word in the link that was followed. */
  constructor(word = "") {
    this.word.value = word;
  }

  async load(): Promise<void> {
    const about = (await (await fetch("about.json")).json()) as AboutClass;
    // The class is closed to new pupils, so everybody has been here before.
    if (!about.open) this.isNew.value = false;
    this.about.value = about;
  }

  /** Type a word or a name; what was wrong with it is put right. */
  type(place: "word" | "name", text: string): void {
    this[place].value = text;
    if (this.wrong.peek() === place) this.problem.value = null;
  }

  /** Ask whether the word is right; return whether it is. */
  async tryWord(): Promise<boolean> {
    const word = this.word.peek();
    if (!word.trim() || this.isKnownWord.peek()) return this.isKnownWord.peek();
    const answer = await post("word", { word } satisfies TryWord);
    // Something else may have been typed meanwhile.
    if (word !== this.word.peek()) return false;
    this.problem.value = answer.ok ? null : await reasonOf(answer);
    if (answer.ok) this.known.value = word;
    return answer.ok;
  }

  /** Add a picture to the PIN; the last one is taken back. */
  press(picture: Picture): void {
    this.problem.value = null;
    const chosen = this.pictures.peek();
    if (chosen.at(-1) === picture) this.back();
    else if (chosen.length < LENGTH && !chosen.includes(picture)) this.pictures.value = [...chosen, picture];
  }

  /** Take the last picture back. */
  back(): void {
    this.pictures.value = this.pictures.peek().slice(0, -1);
  }

  /** Come in. */
  async join(isFirstName = false): Promise<void> {
    this.problem.value = null;
    const pictures = this.isNew.peek() ? null : this.pictures.peek();
    const answer = await post("join", {
      word: this.word.peek(),
      name: this.name.peek(),
      pictures: pictures && [...pictures],
      is_first_name: isFirstName,
    } satisfies Join);
    if (!answer.ok) {
      this.pictures.value = [];
      this.problem.value = await reasonOf(answer);
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

function post(path: string, message: object): Promise<Response> {
  return fetch(path, { method: "POST", body: JSON.stringify(message) });
}

async function reasonOf(answer: Response): Promise<Phrase> {
  return ((await answer.json()) as NotJoined).message;
}
