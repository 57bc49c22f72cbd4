/** Looking back at a run: asks for one moment after the other, never for two at once. */

import { effect, signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { LookBack, TimeMark } from "../protocol/messages";
import { PAUSED, type Running } from "./running";

/** States in which a run does not go on, so that its timeline is complete. */
const AT_REST = new Set(["paused", "held", "input", "ended"]);

/** Steps that may wait for an answer: those of a held key end soon after it is let go. */
const MOST_WAITING = 8;

export type Direction = -1 | 1;
type Asked = Omit<LookBack, "kind">;
/** What the buttons step to. */
export const STEPS = ["line", "event", "turn"] as const;
export type StepTo = (typeof STEPS)[number];

export class LookingBack {
  readonly stepTo = signal<StepTo>("line");
  /** The marks that the buttons go to; empty for all. */
  readonly markSort = signal<TimeMark["sort"] | "">("");
  private asked = false;
  /** Whether the answer that is still to come is no longer wanted. */
  private leaves = false;
  /** What to ask for next; a step starts at the moment that is shown by then. */
  private waiting: (() => Asked)[] = [];

  constructor(
    private readonly running: Running,
    private readonly connection: Connection,
  ) {
    connection.on("Past", () => this.next());
    connection.onRefused(["LookBack"], () => this.next());
    // Who went back to now, or began another run, no longer wants them.
    effect(() => {
      if (!running.past.value) this.waiting = [];
    });
    effect(() => {
      const { state } = running.state.value;
      if (AT_REST.has(state)) this.readTimeline();
      if (PAUSED.has(state)) connection.send({ kind: "ReadValues" });
    });
  }

  /** A connection that broke gives no answer any more. */
  reset(): void {
    this.asked = this.leaves = false;
    this.waiting = [];
  }

  readTimeline(): void {
    this.connection.send({ kind: "ReadTimeline" });
  }

  /**
   * Show the moment at a time in s, or of that time the line of an event; of those that are asked
   * for quickly, the last one.
   */
  look(time: number, event?: number): void {
    this.waiting = [];
    const place: Asked = { time: Math.max(0, time) };
    this.ask(() => (event === undefined ? place : { ...place, event: event - 1, step: 1, to: "line" }));
  }

  /** Show the present again, also if another moment is still on its way. */
  leave(): void {
    this.waiting = [];
    this.leaves = this.asked;
    if (this.running.past.peek()) this.running.leavePast();
  }

  /** Go to the step before or after the moment that is shown. */
  step(by: Direction): void {
    this.go(by, this.stepTo.peek());
  }

  /** Go to the mark before or after the moment that is shown. */
  toMark(by: Direction): void {
    this.go(by, "mark", this.markSort.peek());
  }

  /** Go to where a variable got another value, before or after the moment that is shown. */
  toChange(by: Direction, variable: string): void {
    this.go(by, "change", variable);
  }

  /** Go to where a block ran, before or after the moment that is shown. */
  toRun(by: Direction, block: string): void {
    this.go(by, "run", block);
  }

  /** The moment that is shown, in s. */
  get time(): number {
    return this.running.past.value?.time ?? this.running.timeline.value?.end ?? 0;
  }

  private go(step: Direction, to: NonNullable<LookBack["to"]>, subject = ""): void {
    const event = () => this.running.past.peek()?.event ?? null;
    this.ask(() => ({ time: this.time, event: event(), step, to, subject }));
  }

  private ask(wanted: () => Asked): void {
    this.leaves = false;
    if (this.waiting.length < MOST_WAITING) this.waiting.push(wanted);
    if (!this.asked) this.next();
  }

  private next(): void {
    const wanted = this.waiting.shift();
    this.asked = wanted !== undefined;
    if (this.leaves) this.leave();
    if (wanted) this.connection.send({ kind: "LookBack", ...wanted() });
  }
}
