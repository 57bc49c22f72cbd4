/** What the pupil has handed in, and what is back, for a page that shows a pupil's program. */

import { signal } from "@preact/signals";

import type { OwnHandIn } from "../../protocol/classroom";
import type { Connection } from "../../protocol/connection";

export class HandInNews {
  /** Null outside a class, and on the teacher's pages. */
  readonly all = signal<readonly OwnHandIn[] | null>(null);
  /** When what the pupil has put away came back, by lesson and step. */
  readonly read = signal<ReadonlyMap<string, number>>(new Map());

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
