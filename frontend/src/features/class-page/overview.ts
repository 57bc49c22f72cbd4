/** What the wall says of the class as a whole. */

import type { LessonOffer, MissedCheck, Seat, WaitingHandIn } from "../../protocol/classroom";
import { isToMark, stateOf } from "./states";

/** Of how many pupils a mistake is a common one. */
const COMMON = 2;

/** Those who wait for the teacher, the one who has waited longest first. */
export function waiting(seats: readonly Seat[]): Seat[] {
  const all = (state: string) => seats.filter((seat) => stateOf(seat) === state);
  const longest = (by: (seat: Seat) => number) => (one: Seat, other: Seat) => by(other) - by(one);
  return [
    ...all("help").sort(longest(({ waits = 0 }) => waits)),
    ...all("stuck").sort(longest(({ stuck = 0 }) => stuck)),
  ];
}

/** Those who show the teacher a project, the one who has waited longest first. */
export function showing(seats: readonly Seat[]): Seat[] {
  const since = ({ shows_since = 0 }: Seat) => shows_since;
  return seats.filter(({ shows }) => shows).sort((one, other) => since(one) - since(other));
}

/** How many pupils are in each step of a lesson, and how many have not begun it. */
export interface Places {
  readonly steps: readonly number[];
  readonly notBegun: number;
}

export function placesIn(seats: readonly Seat[], lesson: string, steps: number): Places {
  const at = Array.from({ length: steps }, () => 0);
  let notBegun = 0;
  for (const { lesson_name, step = 0, begun } of seats) {
    if (begun && lesson_name === lesson && step >= 1 && step <= steps) at[step - 1]! += 1;
    else notBegun += 1;
  }
  return { steps: at, notBegun };
}

/** What most pupils in a step have missed in their last run. */
export interface CommonMistake {
  readonly step: number;
  /** Who misses it, and who has tried the step. */
  readonly count: number;
  readonly tried: number;
  readonly missed: MissedCheck;
}

export function commonMistake(seats: readonly Seat[], lesson: string): CommonMistake | null {
  const there = seats.filter(({ lesson_name, tries = 0 }) => lesson_name === lesson && tries > 0);
  const groups = new Map<string, { step: number; missed: MissedCheck[] }>();
  for (const { step = 0, missed } of there) {
    if (!missed) continue;
    const key = JSON.stringify([step, missed.goal]);
    groups.set(key, { step, missed: [...(groups.get(key)?.missed ?? []), missed] });
  }
  const [most] = [...groups.values()].sort((one, other) => other.missed.length - one.missed.length);
  if (!most || most.missed.length < COMMON) return null;
  const tried = there.filter(({ step }) => step === most.step).length;
  return { step: most.step, count: most.missed.length, tried, missed: agreed(most.missed) };
}

/** What all of them say: the check, and the reason if they all have the same. */
function agreed(all: readonly MissedCheck[]): MissedCheck {
  const [first] = all;
  const same = all.every(({ reason }) => JSON.stringify(reason) === JSON.stringify(first!.reason));
  return same ? first! : { goal: first!.goal };
}

/** The lesson that most pupils are in; empty if they are in none. */
export function usualLesson(seats: readonly Seat[]): string {
  const found = new Map<string, number>();
  for (const { lesson_name: name } of seats) if (name) found.set(name, (found.get(name) ?? 0) + 1);
  return [...found].sort(([, one], [, other]) => other - one)[0]?.[0] ?? "";
}

/** The lesson after this one, or the first. */
export function nextAfter(offers: readonly LessonOffer[], lesson: LessonOffer | undefined): LessonOffer | undefined {
  return offers[offers.findIndex(({ name }) => name === lesson?.name) + 1];
}

/** Those who have done all steps of a lesson, or handed in its last one. */
export function readyFor(seats: readonly Seat[], { name, steps }: LessonOffer): Seat[] {
  return seats.filter(({ lesson_name, step, done = [], hand_in }) => {
    const isDone = done.length === steps.length && done.every(Boolean);
    return lesson_name === name && (isDone || (!!hand_in && step === steps.length));
  });
}

/** A line of the list of hand-ins. */
export interface FinishedWork {
  readonly seat: Seat;
  /** Whether the teacher has to hand it back. */
  readonly isToMark: boolean;
  /** The hand-in, if it is not that of the step that the pupil has open. */
  readonly left?: WaitingHandIn;
}

/**
 * The work that is ready to be looked at: what is to be handed back, first in open steps and then what pupils have
 * left behind, the newest first; last the lessons that are done.
 */
export function finishedWork(seats: readonly Seat[], leftBehind: readonly WaitingHandIn[] = []): FinishedWork[] {
  const ready = seats
    .filter(
      ({ hand_in, steps = 0, done = [] }) => hand_in || (steps > 0 && done.length === steps && done.every(Boolean)),
    )
    .sort((one, other) => (one.name ?? "").localeCompare(other.name ?? ""))
    .map((seat) => ({ seat, isToMark: isToMark(seat) }));
  const left = leftBehind.flatMap((left) => {
    const seat = seats.find(({ id }) => id === left.pupil);
    return seat ? [{ seat, isToMark: true, left }] : [];
  });
  return [...ready.filter((work) => work.isToMark), ...left, ...ready.filter((work) => !work.isToMark)];
}
