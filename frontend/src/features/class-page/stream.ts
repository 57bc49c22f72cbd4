/** The stream of the wall and of the projector. */

import { signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import { Channel, socketAt } from "../../protocol/channel";
import type {
  FromTeacher,
  LessonOffer,
  NewPin,
  Plan,
  Projected,
  Seat,
  ToTeacher,
  WaitingHandIns,
  Wall,
} from "../../protocol/classroom";

export class ClassStream extends Channel<FromTeacher, ToTeacher> {
  readonly wall = signal<Wall | null>(null);
  readonly offers = signal<readonly LessonOffer[]>([]);
  readonly seats = signal<ReadonlyMap<string, Seat>>(new Map());
  readonly plans = signal<ReadonlyMap<string, Plan>>(new Map());
  /** What waits to be handed back, except for the work in the steps that pupils have open. */
  readonly waiting = signal<WaitingHandIns>({ kind: "WaitingHandIns" });
  readonly projected = signal<Projected | null>(null);
  readonly pin = signal<NewPin | null>(null);
  readonly refused = signal<Phrase | null>(null);
  /** Hints that are not sent yet, by pupil; those for all have an empty name. */
  readonly drafts = new Map<string, string>();

  /** @param name of the websocket, relative to the page: the wall's, from the wall or from a pupil's record, or the projector's. */
  constructor(name: "wall" | "../../wall" | "projected") {
    super(socketAt(name));
    this.on("Wall", (wall) => this.show(wall));
    this.on("Offers", ({ lessons }) => (this.offers.value = lessons));
    this.on("Seats", ({ seats }) => {
      const before = this.seats.peek();
      this.seats.value = new Map([
        ...before,
        ...seats.map((seat) => [seat.id, whole(seat, before.get(seat.id))] as const),
      ]);
    });
    this.on("Plan", (plan) => {
      this.plans.value = new Map([...this.plans.peek(), [plan.pupil, plan]]);
    });
    this.on("WaitingHandIns", (waiting) => (this.waiting.value = waiting));
    this.on("NewPin", (pin) => (this.pin.value = pin));
    this.on("Refused", ({ message }) => (this.refused.value = message));
    this.on("Projected", (projected) => (this.projected.value = projected));
  }

  /** Have all pages rest, or go on. The button follows at once, so that two presses do not say the same. */
  rest(on: boolean): void {
    const wall = this.wall.peek();
    if (this.send({ kind: "EyesUp", on }) && wall) this.wall.value = { ...wall, eyes_up: on };
  }

  /** Send a hint to a pupil, or to all; return whether it is on its way. Until then it is kept. */
  hint(pupil: string, text: string): boolean {
    const isSent = this.send({ kind: "SendHint", text: text.trim(), pupil: pupil || null });
    if (isSent) this.drafts.delete(pupil);
    return isSent;
  }

  private show(wall: Wall): void {
    this.wall.value = wall;
    // Pupils who have left the class are no longer shown.
    const pupils = new Set(wall.pupils);
    const left = [...this.seats.peek()].filter(([id]) => pupils.has(id));
    if (left.length < this.seats.peek().size) this.seats.value = new Map(left);
  }
}

/** A seat with its whole way: the server leaves out the beginning, if that has not changed. */
function whole(seat: Seat, before: Seat | undefined): Seat {
  const { kept = 0, way = [] } = seat;
  return kept ? { ...seat, way: [...(before?.way ?? []).slice(0, kept), ...way] } : seat;
}
