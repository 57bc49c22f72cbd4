/** The stream of the wall and of the projector. */

import { signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import { Channel } from "../../protocol/channel";
import type { FromTeacher, NewPin, Plan, Projected, Seat, ToTeacher, Wall } from "../../protocol/classroom";

export class ClassStream extends Channel<FromTeacher, ToTeacher> {
  readonly wall = signal<Wall | null>(null);
  readonly seats = signal<ReadonlyMap<string, Seat>>(new Map());
  readonly plans = signal<ReadonlyMap<string, Plan>>(new Map());
  readonly projected = signal<Projected | null>(null);
  readonly pin = signal<NewPin | null>(null);
  readonly refused = signal<Phrase | null>(null);

  /** @param name of the websocket: `wall` or `projected`. */
  constructor(name: "wall" | "projected") {
    const address = new URL(name, location.href);
    address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
    super(address);
    this.on("Wall", (wall) => this.show(wall));
    this.on("Seats", ({ seats }) => {
      this.seats.value = new Map([...this.seats.peek(), ...seats.map((seat) => [seat.id, seat] as const)]);
    });
    this.on("Plan", (plan) => {
      this.plans.value = new Map([...this.plans.peek(), [plan.pupil, plan]]);
    });
    this.on("NewPin", (pin) => (this.pin.value = pin));
    this.on("Refused", ({ message }) => (this.refused.value = message));
    this.on("Projected", (projected) => (this.projected.value = projected));
  }

  /** Have all pages rest, or go on. The button follows at once, so that two presses do not say the same. */
  rest(on: boolean): void {
    const wall = this.wall.peek();
    if (this.send({ kind: "EyesUp", on }) && wall) this.wall.value = { ...wall, eyes_up: on };
  }

  private show(wall: Wall): void {
    this.wall.value = wall;
    // Pupils who have left the class are no longer shown.
    const pupils = new Set(wall.pupils);
    const left = [...this.seats.peek()].filter(([id]) => pupils.has(id));
    if (left.length < this.seats.peek().size) this.seats.value = new Map(left);
  }
}
