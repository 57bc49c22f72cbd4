import { expect, test } from "vitest";

import {
  commonMistake,
  finishedWork,
  nextAfter,
  placesIn,
  readyFor,
  showing,
  waiting,
} from "../../src/features/class-page/overview";
import { counts, inOrder, stateOf } from "../../src/features/class-page/states";
import type { MissedCheck, Seat } from "../../src/protocol/classroom";

function seat(id: string, values: Partial<Seat> = {}): Seat {
  return { id, name: id, here: true, begun: true, state: "ended", ...values };
}

const ids = (seats: readonly Seat[]) => seats.map(({ id }) => id);
const at = (step: number, values: Partial<Seat> = {}) => ({ lesson_name: "one", step, tries: 1, ...values });
const missed = (goal: string, mm?: number): MissedCheck => ({
  goal: { text: goal },
  ...(mm === undefined ? {} : { reason: { code: "short", values: { mm } } }),
});

test.each([
  ["help", { hand: true, here: false, begun: false }],
  ["not-begun", { begun: false }],
  ["not-begun", { begun: false, here: false, gone: 600 }],
  ["away", { here: false, gone: 60 }],
  ["editing", { here: false, gone: 30 }],
  ["running", { state: "running", stuck: 900 }],
  ["running", { state: "input" }],
  ["stuck", { stuck: 300 }],
  ["editing", { stuck: 295 }],
  ["handed-in", { hand_in: "to mark", here: false, gone: 600 }],
  ["editing", { hand_in: "handed back" }],
] as const)("a pupil is %s", (state, values) => expect(stateOf(seat("a", values))).toBe(state));

test("those who need help come first, the one who has waited longest before the others", () => {
  const class7b = [
    seat("away", { here: false, gone: 90 }),
    seat("editing"),
    seat("later", { hand: true, waits: 10 }),
    seat("stuck", { stuck: 400 }),
    seat("longer", { hand: true, waits: 90 }),
  ];
  expect(ids(inOrder(class7b, "need"))).toEqual(["longer", "later", "stuck", "editing", "away"]);
  expect(ids(inOrder(class7b, "name"))).toEqual(["away", "editing", "later", "longer", "stuck"]);
  expect(ids(waiting(class7b))).toEqual(["longer", "later", "stuck"]);
  expect(counts(class7b).get("help")).toBe(2);
});

test("those who show a project wait, too, whatever they do meanwhile", () => {
  const class7b = [
    seat("newest", { shows: "Star", shows_since: 30 }),
    seat("asks", { hand: true, waits: 10, shows: "Square", shows_since: 20 }),
    seat("away", { here: false, gone: 90, shows: "Spiral", shows_since: 10 }),
    seat("editing"),
  ];
  expect(ids(showing(class7b))).toEqual(["away", "asks", "newest"]);
  expect(ids(waiting(class7b))).toEqual(["asks"]);
});

test("pupils who are farthest come first if the teacher wants that", () => {
  const class7b = [seat("a", at(2)), seat("b", at(4)), seat("c", at(4, { stars: 3 }))];
  expect(ids(inOrder(class7b, "step"))).toEqual(["c", "b", "a"]);
});

test("pupils are counted in the steps of the lesson, and all others have not begun it", () => {
  const class7b = [
    seat("a", at(1)),
    seat("b", at(2)),
    seat("c", at(2)),
    seat("d", at(2, { lesson_name: "two" })),
    seat("e", at(1, { begun: false })),
  ];
  expect(placesIn(class7b, "one", 3)).toEqual({ steps: [1, 2, 0], notBegun: 2 });
});

test("what most pupils miss is said with the reason that they share", () => {
  const class7b = [
    seat("a", at(4, { missed: missed("corners", 100) })),
    seat("b", at(4, { missed: missed("corners", 100) })),
    seat("c", at(4, { missed: missed("loop") })),
    seat("d", at(4)),
    seat("e", at(4, { tries: 0 })),
  ];
  expect(commonMistake(class7b, "one")).toEqual({ step: 4, count: 2, tried: 4, missed: missed("corners", 100) });
});

test("pupils who miss the same by other amounts share the check only", () => {
  const class7b = [
    seat("a", at(4, { missed: missed("corners", 100) })),
    seat("b", at(4, { missed: missed("corners", 90) })),
  ];
  expect(commonMistake(class7b, "one")?.missed).toEqual(missed("corners"));
});

test("one pupil's mistake is no common one, and who has not tried makes none", () => {
  const class7b = [
    seat("a", at(4, { missed: missed("corners") })),
    seat("b", at(4, { missed: missed("corners"), tries: 0 })),
  ];
  expect(commonMistake(class7b, "one")).toBeNull();
});

test("work is ready when all steps are done or it is handed in", () => {
  const class7b = [
    seat("b", { steps: 2, done: [true, true] }),
    seat("a", { hand_in: "to mark", steps: 2, done: [true, false] }),
    seat("c", { steps: 2, done: [true, false] }),
    seat("d"),
  ];
  expect(ids(finishedWork(class7b).map(({ seat }) => seat))).toEqual(["a", "b"]);
});

test("what is to be handed back comes first, also what pupils have left behind", () => {
  const done = { steps: 2, done: [true, true] };
  const class7b = [seat("a", done), seat("b", { hand_in: "to mark" }), seat("c", { ...done, hand_in: "handed back" })];
  const left = (pupil: string, step: number) => ({ pupil, lesson: "one", title: "One", step });
  const work = finishedWork(class7b, [left("c", 2), left("gone", 1), left("a", 1)]);
  const shown = work.map(({ seat, isToMark, left }) => [seat.id, isToMark, left?.step]);
  expect(shown).toEqual([
    ["b", true, undefined],
    ["c", true, 2],
    ["a", true, 1],
    ["a", false, undefined],
    ["c", false, undefined],
  ]);
});

test("pupils are ready for the next lesson once all steps are done, or the last one is handed in", () => {
  const lesson = { name: "one", title: "One", level: 1, minutes: 30, robots: [], steps: ["Predict", "Run"] };
  const class7b = [
    seat("a", at(1, { done: [true, true] })),
    seat("b", at(2, { done: [true, false], hand_in: "to check" })),
    seat("c", at(1, { done: [true, false], hand_in: "to check" })),
    seat("d", { ...at(1, { done: [true, true] }), lesson_name: "another" }),
    seat("e"),
  ];
  expect(ids(readyFor(class7b, lesson))).toEqual(["a", "b"]);
  const next = { ...lesson, name: "two" };
  expect([nextAfter([lesson, next], lesson), nextAfter([lesson, next], next)]).toEqual([next, undefined]);
});
