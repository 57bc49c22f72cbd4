import { signal } from "@preact/signals";
import { expect, test } from "vitest";

import { HandInNews } from "../../src/features/in-class/hand-ins";
import { linesToNote, notedLine, numberIn } from "../../src/features/in-class/noted-line";
import type { ProgramState } from "../../src/model/program";
import type { OwnHandIn } from "../../src/protocol/classroom";
import type { LessonShown, Place } from "../../src/protocol/messages";
import { FakeConnection } from "../fake-connection";

const PROGRAM = "main:\n    repeat 3:\n        turn(90)\n    end\n    turn(90)\nend\n";
const REPEAT = notedLine(PROGRAM, 2);
const PLACES: Place[] = [
  ["main", 1, 6, 1, 5],
  ["repeat", 2, 4, 2, 3],
  ["first turn", 3, 3, 3, 3],
  ["last turn", 5, 5, 4, 4],
];

test("a note can be about each line that says something", () => {
  expect(linesToNote(PROGRAM).map(({ number }) => number)).toEqual([1, 2, 3, 5]);
  expect(REPEAT).toEqual({ number: 2, text: "repeat 3:" });
});

test("what is kept of a line has a limit, and no half letter", () => {
  expect(notedLine("😀".repeat(300), 1).text).toBe("😀".repeat(200));
});

test.each([
  ["it has not moved", PROGRAM, 2],
  ["lines were added above", `# Mine\n\n${PROGRAM}`, 4],
  ["its number was changed", PROGRAM.replace("3", "4"), 2],
  ["it is gone", "main:\n    turn(90)\nend\n", 0],
  ["the program is shorter", "", 0],
])("the line of a note is looked for where %s", (_, program, number) => {
  expect(numberIn(program, REPEAT)).toBe(number);
});

test("of several equal lines it is the nearest", () => {
  expect(numberIn(PROGRAM, { number: 5, text: "turn(90)" })).toBe(5);
  expect(numberIn(PROGRAM, { number: 3, text: "turn(90)" })).toBe(3);
});

function handedBack(more: Partial<OwnHandIn> = {}): OwnHandIn {
  return { lesson: "square", step: 4, at: 1, back: { at: 2, note: "How often?", line: REPEAT }, ...more };
}

function opened(blocktext = PROGRAM, places = PLACES) {
  const connection = new FakeConnection();
  const news = new HandInNews(connection.real);
  const state = (text: string, there: readonly Place[]) =>
    ({ blocktext: text, python: "", places: there }) as unknown as ProgramState;
  const program = signal(state(blocktext, places));
  const lesson = signal({ name: "square", step: 4 } as LessonShown);
  news.follow(program, lesson);
  return {
    news,
    lesson,
    hear: (handIn: OwnHandIn) => connection.tell({ kind: "OwnHandIns", hand_ins: [handIn] } as never),
    show: (text: string, there: readonly Place[]) => (program.value = state(text, there)),
  };
}

test("the block of the note is marked, and stays marked while the pupil changes it", () => {
  const { news, hear, show } = opened();
  hear(handedBack());
  expect(news.noted.value).toBe("repeat");
  hear(handedBack({ improving: true }));
  show(PROGRAM.replace("repeat 3", "while true"), PLACES);
  expect(news.noted.value).toBe("repeat");
});

test("a block that is deleted is not marked, nor is another one", () => {
  const { news, hear, show } = opened();
  hear(handedBack());
  show("main:\n    turn(90)\nend\n", [PLACES[0]!, ["last turn", 2, 2, 2, 2]]);
  expect(news.noted.value).toBe(null);
});

test.each([
  ["handed in again", (it: ReturnType<typeof opened>) => it.hear(handedBack({ waits: true }))],
  ["put away", (it: ReturnType<typeof opened>) => it.news.putAway(handedBack())],
  [
    "of another step",
    (it: ReturnType<typeof opened>) => (it.lesson.value = { name: "square", step: 3 } as LessonShown),
  ],
])("the mark is gone once the work is %s", (_, change) => {
  const it = opened();
  it.hear(handedBack());
  change(it);
  expect(it.news.noted.value).toBe(null);
});
