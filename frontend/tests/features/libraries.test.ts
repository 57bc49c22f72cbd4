import { expect, test } from "vitest";

import {
  clashOf,
  fileOf,
  type Incoming,
  isReady,
  renamed,
  replaces,
  withAnswer,
} from "../../src/features/libraries/incoming";
import type { LibraryRead } from "../../src/protocol/messages";

const FILE: Incoming = { filename: "maze.lblib", content: "", renamings: [], read: null };

function read(values: Partial<LibraryRead>): LibraryRead {
  return { filename: "maze.lblib", library: { name: "maze" }, ...values } as LibraryRead;
}

const CLASH = [{ skill: "turn", place: { code: "library-place-block", values: {} } }];

test("a skill whose name is taken is offered a name with the library's in front", () => {
  expect(withAnswer(FILE, read({ clashes: CLASH })).renamings).toEqual([
    { skill: "turn", place: { code: "library-place-block", values: {} }, name: "maze_turn" },
  ]);
});

test("a file is sent with the new names of its skills", () => {
  const file = renamed(withAnswer(FILE, read({ clashes: CLASH })), "turn", " spin ");
  expect(fileOf(file).renames).toEqual({ turn: "spin" });
});

const TOOLS = { code: "library-place-library", values: { name: "tools" } };

test("a new name that is taken too clashes and is not renamed again", () => {
  const first = withAnswer(FILE, read({ clashes: CLASH }));
  const second = withAnswer(first, read({ clashes: [{ skill: "maze_turn", place: TOOLS }] }));
  expect(second.renamings).toHaveLength(1);
  expect(clashOf(second, second.renamings[0] as Incoming["renamings"][0])?.place).toBe(TOOLS);
});

test("a file is ready once it has been read without problem or clash", () => {
  const states = [FILE, { ...FILE, read: read({}) }, { ...FILE, read: read({ clashes: CLASH }) }];
  expect(states.map(isReady)).toEqual([false, true, false]);
});

test("a file replaces what is installed unless it is newer", () => {
  const installed = (is_newer: boolean) => ({ ...FILE, read: read({ installed: "1.0", is_newer }) as LibraryRead });
  expect([replaces(installed(false)), replaces(installed(true)), replaces(FILE)]).toEqual([true, false, false]);
});
