/** What a pupil is doing, as the wall says it: who needs the teacher most comes first. */

import type { Seat } from "../../protocol/classroom";
import type { IconName } from "../../ui/icons";

/** Seconds of work without a star or a run that ended well. */
const STUCK = 300;
/** Seconds after which a pupil without a page, or whose server is silent, is away: a page may just be loading again. */
const AWAY = 60;

/** In their order on the wall. */
export const STATES = ["help", "stuck", "running", "editing", "handed-in", "not-begun", "away"] as const;
export type State = (typeof STATES)[number];

export const STATE_ICONS = {
  help: "hand",
  stuck: "stuck",
  running: "run",
  editing: "edit",
  "handed-in": "handedIn",
  "not-begun": "notBegun",
  away: "away",
} as const satisfies Readonly<Record<State, IconName>>;

const WORKING: ReadonlySet<Seat["state"]> = new Set(["starting", "running", "paused", "held", "input"]);

/** What has gone back to the pupil, who works on it again. */
const BACK: ReadonlySet<string> = new Set(["handed back", "improving"]);

export function stateOf(seat: Seat): State {
  const { hand, begun, here, gone = 0, silent = 0, stuck = 0, state } = seat;
  if (hand) return "help";
  if (isToMark(seat)) return "handed-in";
  if (!begun) return "not-begun";
  if ((!here && gone >= AWAY) || silent >= AWAY) return "away";
  if (WORKING.has(state)) return "running";
  return stuck >= STUCK ? "stuck" : "editing";
}

/** Whether the pupil has handed in what is open, and has not got it back. */
export function isToMark({ hand_in }: Seat): boolean {
  return !!hand_in && !BACK.has(hand_in);
}

/** Whether a picture is old: no page of the pupil is open, or there is no news from the pupil's server. */
export function isOld({ here, silent = 0 }: Seat): boolean {
  return !here || silent > 0;
}

export const ORDERS = ["need", "name", "step"] as const;
export type Order = (typeof ORDERS)[number];

const COMPARISONS: Readonly<Record<Order, (one: Seat, other: Seat) => number>> = {
  need: byNeed,
  name: () => 0,
  step: (one, other) => progress(other) - progress(one),
};

/** By what the teacher has chosen, and by name among equals. */
export function inOrder(seats: Iterable<Seat>, order: Order): Seat[] {
  return [...seats].sort(
    (one, other) =>
      COMPARISONS[order](one, other) ||
      (one.name ?? "").localeCompare(other.name ?? "") ||
      one.id.localeCompare(other.id),
  );
}

/** Among those who need help or are stuck, the one who has waited longest comes first. */
function byNeed(one: Seat, other: Seat): number {
  const [state, next] = [stateOf(one), stateOf(other)];
  if (state !== next) return STATES.indexOf(state) - STATES.indexOf(next);
  if (state === "help") return (other.waits ?? 0) - (one.waits ?? 0);
  return state === "stuck" ? (other.stuck ?? 0) - (one.stuck ?? 0) : 0;
}

function progress({ step = 0, stars = 0 }: Seat): number {
  return step * 100 + stars;
}

/** How many pupils are in each state. */
export function counts(seats: Iterable<Seat>): ReadonlyMap<State, number> {
  const found = new Map<State, number>();
  for (const seat of seats) found.set(stateOf(seat), (found.get(stateOf(seat)) ?? 0) + 1);
  return found;
}

/** Whole minutes, at least one. */
export function minutes(seconds = 0): number {
  return Math.max(1, Math.floor(seconds / 60));
}
