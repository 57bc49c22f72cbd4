import { signal } from "@preact/signals";
import { beforeAll, expect, test } from "vitest";

import { startLanguage } from "../../src/i18n";
import { endOf, goalName, goalsOf, winningGoal } from "../../src/model/game-words";
import type { GameNow, GoalNow } from "../../src/protocol/messages";

beforeAll(() => startLanguage(signal("en")));

const PLAYERS = [
  { name: "ada", score: 0, lives: null, team: "Red" },
  { name: "ben", score: 0, lives: null, team: "Blue" },
];
const WON: GameNow = { players: PLAYERS, won: true, reason: "east", winner: "ada", team: "Red" };
const GOALS: GoalNow[] = [
  { name: "east", sort: "reach", state: "reached", time: 2, team: "Red" },
  { name: "west", sort: "reach", state: "open", time: null, team: "Blue" },
  { name: "show", sort: "show", state: "open", time: null },
];

test.each<[string, Partial<GameNow>]>([
  ["Red wins", {}],
  ["ada wins", { team: "" }],
  ["You win", { team: "", players: PLAYERS.slice(0, 1) }],
  ["You win", { team: "", winner: "" }],
  ["Game over", { won: false, winner: "", team: "" }],
  ["Time is up", { won: false, winner: "", team: "", reason: "time" }],
])("a game ends with %s", (words, changed) => {
  expect(endOf({ ...WON, ...changed })).toBe(words);
});

test("the card names the goal that won, and who reached it for a team", () => {
  expect(winningGoal(WON, GOALS)).toBe("east (ada)");
  expect(winningGoal({ ...WON, team: "" }, GOALS)).toBe("east");
  expect(winningGoal({ ...WON, reason: "program" }, GOALS)).toBeNull();
  expect(winningGoal({ ...WON, winner: "" }, GOALS)).toBeNull();
});

test("a goal has the name of its team beside its own", () => {
  expect(GOALS.map(goalName)).toEqual(["east (Red)", "west (Blue)", "show"]);
});

test("a robot has the goals of its team and those of all", () => {
  const names = (robot: string) => goalsOf(robot, GOALS, WON).map(({ name }) => name);
  expect(names("ada")).toEqual(["east", "show"]);
  expect(names("ben")).toEqual(["west", "show"]);
  expect(names("nobody")).toEqual(["east", "west", "show"]);
  expect(goalsOf("ada", GOALS)).toEqual(GOALS);
});
