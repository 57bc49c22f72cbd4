// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { act, screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { Classes } from "../../src/features/teachers/classes";
import { Teachers } from "../../src/features/teachers/teachers";
import { open } from "../dialog";

/** The page for teachers, opened before the server has said that the user teaches. */
function openEarly() {
  const listed: string[] = [];
  const teaches = signal(false);
  open(Teachers, (connection) => ({
    classes: new Classes(connection.real),
    lessons: { teaches, choices: signal(null), list: () => listed.push("lessons") },
    blockSets: { ours: signal([]), list: () => listed.push("block sets") },
  }));
  return { listed, teaches };
}

test("a teacher who is quicker than the connection gets lessons and block sets all the same", () => {
  const { listed, teaches } = openEarly();
  expect(listed).toEqual([]);
  act(() => {
    teaches.value = true;
  });
  screen.getByLabelText("First lesson");
  expect(listed).toEqual(["block sets", "lessons"]);
});
