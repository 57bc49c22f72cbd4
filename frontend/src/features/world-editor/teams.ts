/** The teams of a world: they name starts, and goals name them. */

import type { TeamValues, WorldValues } from "../../views/world/scenery/description";

/** The colours of the first teams. */
const COLOURS = ["red", "blue", "green", "yellow", "purple", "orange", "black", "white", "brown", "grey"] as const;
/** As in the world's file. */
export const MOST_TEAMS = COLOURS.length;

/** The world whose teams have only robots that start in it. */
export function manned(world: WorldValues): WorldValues {
  const starts = new Set(world.start.map(({ name }) => name));
  if (world.team.every(({ robots }) => robots.every((name) => starts.has(name)))) return world;
  return withRobots(world, ({ robots }) => robots.filter((name) => starts.has(name)));
}

/** The world in which a renamed start stays in its team. */
export function withStartNamed(world: WorldValues, before: string, after: string): WorldValues {
  return withRobots(world, ({ robots }) => robots.map((name) => (name === before ? after : name)));
}

/** The world in which a start is in a team; null for none. */
export function withStartIn(world: WorldValues, start: string, team: string | null): WorldValues {
  return withRobots(world, ({ name, robots }) => {
    const others = robots.filter((robot) => robot !== start);
    return name === team ? [...others, start] : others;
  });
}

/** A team without robots, of a colour that no other team has. */
export function newTeam({ team }: WorldValues, nameOf: (colour: string) => string): TeamValues {
  const names = new Set(team.map(({ name }) => name));
  const colours = new Set(team.map(({ colour }) => colour));
  const colour = COLOURS.find((free) => !colours.has(free)) ?? COLOURS[0];
  let name = nameOf(colour);
  for (let number = 2; names.has(name); number++) name = `${nameOf(colour)} ${number}`;
  return { name, colour, robots: [] };
}

/** The world with other teams: goals follow a new name, and those of a missing team are for everybody. */
export function withTeams(world: WorldValues, teams: readonly TeamValues[]): WorldValues {
  const left = new Set(teams.map(({ name }) => name));
  const isRenamed = teams.length === world.team.length;
  const after = new Map(world.team.map(({ name }, i) => [name, isRenamed ? (teams[i]?.name ?? null) : null]));
  const goal = (one: { team: string | null }) =>
    one.team === null || left.has(one.team) ? one : { ...one, team: after.get(one.team) ?? null };
  const lists = Object.entries(world.goal).map(([kind, goals]) => [kind, goals.map(goal)]);
  return { ...world, team: [...teams], goal: Object.fromEntries(lists) as WorldValues["goal"] };
}

function withRobots(world: WorldValues, robots: (team: TeamValues) => string[]): WorldValues {
  return { ...world, team: world.team.map((team) => ({ ...team, robots: robots(team) })) };
}
