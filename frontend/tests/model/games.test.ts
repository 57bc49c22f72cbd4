import { expect, test } from "vitest";

import { hasGame, usesGame } from "../../src/model/games";
import type { Workspace } from "../../src/protocol/messages";

const program = (type: string): Workspace => ({ stacks: [[{ type, id: "a" }]], variables: [] }) as unknown as Workspace;

test.each(["collectable", "zone", "gate", "mover", "switch"])("a world with a %s has a game", (table) => {
  expect(hasGame({ [table]: [] })).toBe(false);
  expect(hasGame({ [table]: [{}] })).toBe(true);
});

test("a world with lives or a countdown has a game", () => {
  expect(hasGame({ game: {} as never })).toBe(true);
  expect(hasGame({ game: null })).toBe(false);
  expect(hasGame(undefined)).toBe(false);
});

test.each([
  ["lb_skill_change_score", true],
  ["lb_when_collected", true],
  ["lb_when_is_time_up", true],
  ["lb_skill_turn", false],
  ["lb_when_received", false],
])("a program with %s plays a game: %s", (type, plays) => {
  expect(usesGame(program(type))).toBe(plays);
});
