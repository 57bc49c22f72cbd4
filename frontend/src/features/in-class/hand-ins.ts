/** What the pupil has handed in, and what is back, for a page that shows a pupil's program. */

import { effect, type ReadonlySignal, signal } from "@preact/signals";

import type { ProgramState } from "../../model/program";
import type { HandedBack, OwnHandIn } from "../../protocol/classroom";
import type { Connection } from "../../protocol/connection";
import type { LessonShown } from "../../protocol/messages";
import { blockOf } from "./noted-line";

export class HandInNews {
  /** Null outside a class, and on the teacher's pages. */
  readonly all = signal<readonly OwnHandIn[] | null>(null);
  /** When what the pupil has put away came back, by lesson and step. */
  readonly read = signal<ReadonlyMap<string, number>>(new Map());
  /** The block that the teacher's note is about; null without one, or if it is gone. */
  readonly noted = signal<string | null>(null);
  /** The hand-in whose run is shown; null for none. */
  readonly run = signal<OwnHandIn | null>(null);
  /** What `noted` belongs to. */
  private notedAt = 0;

  constructor(private readonly connection: Connection) {
    connection.on("OwnHandIns", ({ hand_ins = [] }) => (this.all.value = hand_ins));
  }

  /** The hand-in of a step. */
  of(lesson: string, step: number): OwnHandIn | undefined {
    return this.all.value?.find((one) => one.lesson === lesson && one.step === step);
  }

  /** The hand-in of a step if the teacher's answer is to be shown as a whole, until the pupil goes on. */
  back(lesson: string, step: number): OwnHandIn | undefined {
    const found = this.of(lesson, step);
    if (!found?.back || found.waits || found.improving) return undefined;
    return this.read.value.get(placeOf(found)) === found.back.at ? undefined : found;
  }

  /** Mark the block of the note in the open step, also while the pupil changes it. */
  follow(program: ReadonlySignal<ProgramState>, lesson: ReadonlySignal<LessonShown | null>): void {
    effect(() => {
      const state = program.value;
      const { name = "", step = 1 } = lesson.value ?? {};
      this.noted.value = this.notedIn(state, this.readNow(name, step));
    });
  }

  /** What the pupil reads now of what came back in a step. */
  private readNow(lesson: string, step: number): HandedBack | null {
    const found = this.of(lesson, step);
    return (found?.improving || this.back(lesson, step) ? found?.back : null) ?? null;
  }

  private notedIn(state: ProgramState, back: HandedBack | null): string | null {
    if (!back?.line) return null;
    const known = this.notedAt === back.at ? this.noted.peek() : null;
    this.notedAt = back.at;
    return known && state.places.some(([block]) => block === known) ? known : blockOf(back.line, state);
  }

  handIn(): void {
    this.connection.send({ kind: "HandIn" });
  }

  improve({ lesson, step }: OwnHandIn): void {
    this.connection.send({ kind: "ImproveHandIn", lesson, step });
  }

  putAway(handIn: OwnHandIn): void {
    this.read.value = new Map([...this.read.peek(), [placeOf(handIn), handIn.back?.at ?? 0]]);
  }
}

function placeOf({ lesson, step }: OwnHandIn): string {
  return `${lesson} ${step}`;
}

declare module "../../model/page" {
  interface Page {
    readonly handIns: HandInNews;
  }
}
