import { expect, test } from "vitest";

import { created } from "../../src/features/world-editor/creating";
import { newTeam, withStartIn, withTeams } from "../../src/features/world-editor/teams";
import { added, duplicated, emptied, removed, replaced } from "../../src/features/world-editor/things";
import { thingAt } from "../../src/views/world/plan/sorts";
import type { WorldValues } from "../../src/views/world/scenery/description";
import { emptyWorld } from "../worlds";

const FIRST = { sort: "start", index: 0 } as const;

/** A world with two starts, "start" of red and "start 2" of blue, and a goal for each team. */
function divided(): WorldValues {
  let world = emptyWorld();
  for (let i = 0; i < 2; i++) [world] = added(world, "start", created(world, "start", [i * 300, 0]));
  for (let i = 0; i < 2; i++) world = withTeams(world, [...world.team, newTeam(world, String)]);
  world = withStartIn(withStartIn(world, "start", "red"), "start 2", "blue");
  for (const { name } of world.team)
    [world] = added(world, "reach", { ...created(world, "reach", [0, 0]), team: name });
  return world;
}

const teamOf = ({ team }: WorldValues, start: string) =>
  team.find(({ robots }) => robots.includes(start))?.name ?? null;
const robots = ({ team }: WorldValues) => team.map((one) => one.robots);
const goals = ({ goal }: WorldValues) => goal.reach.map(({ team }) => team);

test("new teams have names and colours of their own", () => {
  const { team } = divided();
  expect(team.map(({ name, colour }) => [name, colour])).toEqual([
    ["red", "red"],
    ["blue", "blue"],
  ]);
});

test("a team has a name that no other team has", () => {
  const world = divided();
  const green = { name: "green", colour: "white" as const, robots: [] };
  expect(newTeam(withTeams(world, [...world.team, green]), String).name).toBe("green 2");
});

test("a start is in one team at most", () => {
  const moved = withStartIn(divided(), "start", "blue");
  expect(robots(moved)).toEqual([[], ["start 2", "start"]]);
  expect(teamOf(moved, "start")).toBe("blue");
  expect(robots(withStartIn(moved, "start", null))).toEqual([[], ["start 2"]]);
});

test("a start that is renamed stays in its team, one that is removed leaves it", () => {
  const world = divided();
  const renamed = replaced(world, FIRST, { ...thingAt(world, FIRST), name: "goalkeeper" });
  expect(robots(renamed)).toEqual([["goalkeeper"], ["start 2"]]);
  expect(robots(removed(renamed, FIRST))).toEqual([[], ["start 2"]]);
  expect(robots(duplicated(world, FIRST)[0])).toEqual(robots(world));
});

test("goals follow the name of their team, and are for everybody without it", () => {
  const [red, blue] = divided().team;
  if (!red || !blue) throw new Error("no teams");
  const world = withTeams(divided(), [{ ...red, name: "Lions" }, blue]);
  expect(goals(world)).toEqual(["Lions", "blue"]);
  expect(goals(withTeams(world, [blue]))).toEqual([null, "blue"]);
  expect(goals(withTeams(world, [...world.team, newTeam(world, String)]))).toEqual(["Lions", "blue"]);
});

test("a world that is emptied has no teams", () => {
  expect(emptied(divided()).team).toEqual([]);
});
