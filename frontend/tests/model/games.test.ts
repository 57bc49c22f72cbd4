import { expect, test } from "vitest";

import { hasGame } from "../../src/model/games";

test.each(["collectable", "zone", "gate", "mover", "switch"])("a world with a %s has a game", (table) => {
  expect(hasGame({ [table]: [] })).toBe(false);
  expect(hasGame({ [table]: [{}] })).toBe(true);
});

test("a world with lives or a countdown has a game", () => {
  expect(hasGame({ game: {} as never })).toBe(true);
  expect(hasGame({ game: null })).toBe(false);
  expect(hasGame(undefined)).toBe(false);
});
