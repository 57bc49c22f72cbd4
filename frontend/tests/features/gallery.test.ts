// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { beforeAll, expect, test } from "vitest";

import { neighbour } from "../../src/features/worlds/arrows";
import { able, dots, goalOf, lacking, reason, searched } from "../../src/features/worlds/guide";
import { few, remember } from "../../src/features/worlds/recent";
import { startLanguage } from "../../src/i18n";
import type { RobotChoice, WorldChoice } from "../../src/protocol/messages";

beforeAll(() => startLanguage(signal("en")));

function world(name: string, more: Partial<WorldChoice> = {}): WorldChoice {
  return { name, title: name, own: false, ...more };
}

const EBO: RobotChoice = { name: "sim-ebo", title: "EBO", simulated: true };
const EV3: RobotChoice = { name: "sim-ev3", title: "LEGO EV3", simulated: true, lacks: ["Camera", "red-line"] };
const REAL: RobotChoice = { name: "ebo", title: "EBO", simulated: false };
const TAGS = world("tags", { group: "tags", difficulty: "medium", needs: ["Camera"] });
const LINE = world("line", { group: "lines", difficulty: "tricky", needs: ["black-line"] });
const SQUARE = world("square", { difficulty: "easy", title: "A square to drive: four corners" });
const WORLDS = [TAGS, LINE, SQUARE];

function names(words: string, robot = EBO): readonly string[] {
  return searched(WORLDS, words, robot, (name) => name).map(({ name }) => name);
}

test("worlds come from easy to tricky, and those that the robot can't solve last", () => {
  expect(names("")).toEqual(["square", "tags", "line"]);
  expect(names("", EV3)).toEqual(["square", "line", "tags"]);
});

test.each([
  ["CORNERS", ["square"]],
  ["easy drive", ["square"]],
  ["camera", ["tags"]],
  ["línes", ["line"]],
  ["castle", []],
])("a search for %s looks at titles, goals, groups and difficulties", (words, expected) => {
  expect(names(words)).toEqual(expected);
});

test("a world says which simulated robots can solve it, and what another one lacks", () => {
  expect(able(TAGS, [EBO, EV3, REAL])).toEqual([EBO]);
  expect(lacking(TAGS, EV3)).toEqual(["Camera"]);
  expect(reason(TAGS, [EBO, EV3], EV3)).toMatch(/camera.*EBO/);
  expect(reason(LINE, [EBO, EV3], EV3)).toBe("");
});

test("the name of a world isn't said again in its goal, and an own world has none", () => {
  expect(goalOf(world("sumo", { title: "Sumo: the last robot in the ring wins" }))).toBe(
    "The last robot in the ring wins",
  );
  expect(goalOf(world("mine", { title: "My yard", own: true }))).toBe("");
  expect([dots(SQUARE), dots(TAGS), dots(LINE), dots(world("empty"))]).toEqual([1, 2, 3, 0]);
});

test("the worlds chosen last are offered first, after the one in use", () => {
  const all = [...WORLDS, world("obstacles"), world("empty"), world("far")];
  const shown = () => few(all, "tags").map(({ name }) => name);
  expect(shown()).toEqual(["tags", "square", "obstacles", "line"]);
  remember("far");
  remember("gone");
  expect(shown()).toEqual(["tags", "far", "square", "obstacles"]);
});

const GRID = [
  [0, 0],
  [100, 0],
  [220, 0],
  [0, 100],
  [100, 100],
].map(([left = 0, top = 0]) => ({ left, top, right: left + 90, bottom: top + 90 }));

test.each([
  [0, "ArrowRight", 1],
  [1, "ArrowRight", 2],
  [2, "ArrowRight", -1],
  [1, "ArrowLeft", 0],
  [1, "ArrowDown", 4],
  [2, "ArrowDown", 4],
  [4, "ArrowUp", 1],
  [0, "Tab", -1],
])("from card %i, %s leads to card %i", (from, key, to) => expect(neighbour(GRID, from, key)).toBe(to));
