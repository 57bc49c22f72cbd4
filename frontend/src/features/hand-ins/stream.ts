/** The stream of the page with the hand-ins. */

import { computed, signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import { Channel, socketAt } from "../../protocol/channel";
import type {
  FromTeacher,
  HandInLine,
  HandInList,
  HandInStep,
  HandInSteps,
  NotedLine,
  ShownHandIn,
  ToTeacher,
} from "../../protocol/classroom";
import type { HandInAddress } from "../class-page/hand-in-address";

interface Place {
  readonly lesson: string;
  readonly step: number;
}

export class HandInStream extends Channel<FromTeacher, ToTeacher> {
  readonly steps = signal<HandInSteps | null>(null);
  readonly list = signal<HandInList | null>(null);
  readonly shown = signal<ShownHandIn | null>(null);
  readonly refused = signal<Phrase | null>(null);
  /** The step that is listed. */
  readonly place = signal<Place | null>(null);
  /** The id of the pupil whose hand-in is shown. */
  readonly pupil = signal("");
  /** Whether the run of each hand-in that is shown is seen in 3D. */
  readonly seesRuns = signal(false);
  /** Whether the teacher moves in the list by keyboard, so that the note does not take the focus. */
  staysInList = false;
  /** Changes when the focus goes to the note or to the list of the hand-in that is shown already. */
  readonly focused = signal(0);
  readonly marked = computed(() => (this.list.value?.lines ?? []).filter(({ state }) => state === "marked"));

  /** @param wanted the hand-in that is shown first, if it is there. */
  constructor(private readonly wanted: HandInAddress | null = null) {
    super(socketAt("marking"));
    this.on("HandInSteps", (steps) => this.changed(steps));
    this.on("HandInList", (list) => this.listed(list));
    this.on("ShownHandIn", (shown) => {
      if (shown.line.pupil === this.pupil.peek()) this.shown.value = shown;
    });
    this.on("Refused", ({ message }) => (this.refused.value = message));
  }

  /** List the hand-ins of a step. */
  choose({ lesson, step }: Place): void {
    this.place.value = { lesson, step };
    this.pupil.value = "";
    this.shown.value = null;
    this.list.value = null;
    this.read();
  }

  /** Show a hand-in. */
  show(pupil: string, stay = false): void {
    if (pupil !== this.pupil.peek()) this.staysInList = stay;
    const place = this.place.peek();
    this.pupil.value = pupil;
    if (pupil && place) this.send({ kind: "ReadHandIn", pupil, ...place });
  }

  /** Show a hand-in, and go to its note. */
  write(pupil: string): void {
    this.show(pupil);
    this.staysInList = false;
    this.focused.value += 1;
  }

  /** Go from the note back to the list. */
  toList(): void {
    this.staysInList = true;
    this.focused.value += 1;
  }

  /** Show a hand-in above this one in the list, or below it; the focus goes to its note unless it stays. */
  move(by: number, { stay = false } = {}): void {
    const ids = inOrder(this.list.peek()?.lines ?? []).map(({ pupil }) => pupil);
    const place = Math.min(Math.max(ids.indexOf(this.pupil.peek()) + by, 0), ids.length - 1);
    const next = ids[place];
    if (next && next !== this.pupil.peek()) this.show(next, stay);
  }

  /** Show the next hand-in without a mark: checked before unchecked, after this one in the class before the first. */
  moveOn(): void {
    const lines = this.list.peek()?.lines ?? [];
    const at = lines.findIndex(({ pupil }) => pupil === this.pupil.peek());
    const others = [...lines.slice(at + 1), ...lines.slice(0, Math.max(at, 0))];
    const next = UNMARKED.map((wanted) => others.find(({ state }) => state === wanted)).find(Boolean);
    if (next) this.show(next.pupil);
  }

  collect(): void {
    this.act((place) => ({ kind: "CollectHandIns", ...place }));
  }

  check(): void {
    this.act((place) => ({ kind: "CheckHandIns", ...place }));
  }

  mark(pupil: string, note: string, mark: string, line: NotedLine | null): void {
    this.act((place) => ({ kind: "MarkHandIn", pupil, note, mark, line, ...place }));
  }

  handBack(pupils: string[]): void {
    this.act((place) => ({ kind: "HandBack", pupils, ...place }));
  }

  private act(message: (place: Place) => FromTeacher): void {
    const place = this.place.peek();
    if (!place) return;
    this.refused.value = null;
    this.send(message(place));
  }

  private read(): void {
    const place = this.place.peek();
    if (place) this.send({ kind: "ReadHandIns", ...place });
  }

  private changed(steps: HandInSteps): void {
    const isOther = steps.revision !== this.steps.peek()?.revision;
    this.steps.value = steps;
    if (this.place.peek()) {
      if (isOther) this.read();
    } else this.begin(steps.steps ?? []);
  }

  /** List a step for the first time. */
  private begin(steps: readonly HandInStep[]): void {
    const { wanted } = this;
    const isThere = steps.some(({ lesson, step }) => lesson === wanted?.lesson && step === wanted.step);
    const first = wanted && isThere ? wanted : mostUseful(steps);
    if (!first) return;
    this.choose(first);
    if (first === wanted) this.pupil.value = wanted.pupil;
  }

  private listed(list: HandInList): void {
    const place = this.place.peek();
    if (list.lesson !== place?.lesson || list.step !== place.step) return;
    this.list.value = list;
    const lines = inOrder(list.lines ?? []);
    const isThere = lines.some(({ pupil }) => pupil === this.pupil.peek());
    this.show(isThere ? this.pupil.peek() : (lines[0]?.pupil ?? ""));
  }
}

/** More than a list has. */
export const MOST_LINES = 1000;

/** The groups of the list, by what the teacher has to do. */
export const GROUPS = ["to check", "to mark", "marked", "handed back", "improving"] as const;

const UNMARKED = ["to mark", "to check"] as const;

/** The lines as the list shows them. */
export function inOrder(lines: readonly HandInLine[]): readonly HandInLine[] {
  return GROUPS.flatMap((group) => lines.filter(({ state }) => state === group));
}

/** The step in which most waits for the teacher, else that with the most hand-ins. */
function mostUseful(steps: readonly HandInStep[]): Place | undefined {
  const waiting = ({ to_check = 0, to_mark = 0, marked = 0 }: HandInStep) => to_check + to_mark + marked;
  return [...steps].sort((a, b) => waiting(b) - waiting(a) || (b.count ?? 0) - (a.count ?? 0))[0];
}
