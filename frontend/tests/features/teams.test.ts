import { expect, test } from "vitest";

import { created } from "../../src/features/world-editor/creating";
import { teamOf, withNewTeam, withoutTeam, withStartIn, withTeam } from "../../src/features/world-editor/teams";
import { added, duplicated, emptied, removed, replaced } from "../../src/features/world-editor/things";
import { thingAt } from "../../src/views/world/plan/sorts";
import type { WorldValues } from "../../src/views/world/scenery/description";
import { emptyWorld } from "../worlds";

const FIRST = { sort: "start", index: 0 } as const;

/** A world with two starts, "start" of Team 1 and "start 2" of Team 2, and a goal for each team. */
function divided(): WorldValues {
  let world = emptyWorld();
  for (let i = 0; i < 2; i++) [world] = added(world, "start", created(world, "start", [i * 300, 0]));
  world = withNewTeam(withNewTeam(world, "Team"), "Team");
  world = withStartIn(withStartIn(world, "start", "Team 1"), "start 2", "Team 2");
  for (const { name } of world.team)
    [world] = added(world, "reach", { ...created(world, "reach", [0, 0]), team: name });
  return world;
}

const robots = ({ team }: WorldValues) => team.map((one) => one.robots);
const goals = ({ goal }: WorldValues) => goal.reach.map(({ team }) => team);

test("new teams have names and colours of their own", () => {
  const { team } = divided();
  expect(team.map(({ name, colour }) => [name, colour])).toEqual([
    ["Team 1", "red"],
    ["Team 2", "blue"],
  ]);
});

test("a start is in one team at most", () => {
  const moved = withStartIn(divided(), "start", "Team 2");
  expect(robots(moved)).toEqual([[], ["start 2", "start"]]);
  expect(teamOf(moved, "start")).toBe("Team 2");
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
  const world = withTeam(divided(), 0, { name: "Lions" });
  expect(goals(world)).toEqual(["Lions", "Team 2"]);
  expect(goals(withoutTeam(world, 0))).toEqual([null, "Team 2"]);
});

test("a world that is emptied has no teams", () => {
  expect(emptied(divided()).team).toEqual([]);
});
