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

/** The team that a start is in. */
export function teamOf({ team }: WorldValues, start: string): string | null {
  return team.find(({ robots }) => robots.includes(start))?.name ?? null;
}

/** The world with one more team, without robots, of a colour that no other team has. */
export function withNewTeam(world: WorldValues, stem: string): WorldValues {
  const names = new Set(world.team.map(({ name }) => name));
  const colours = new Set(world.team.map(({ colour }) => colour));
  let number = world.team.length + 1;
  while (names.has(`${stem} ${number}`)) number += 1;
  const colour = COLOURS.find((name) => !colours.has(name)) ?? COLOURS[0];
  return { ...world, team: [...world.team, { name: `${stem} ${number}`, colour, robots: [] }] };
}

/** The world with a team changed; goals follow its name. */
export function withTeam(world: WorldValues, index: number, changed: Partial<TeamValues>): WorldValues {
  const before = world.team[index];
  if (!before) return world;
  const after = { ...before, ...changed };
  const team = world.team.map((old, i) => (i === index ? after : old));
  return withGoalsOf({ ...world, team }, before.name, after.name);
}

/** The world without a team; its goals are for everybody. */
export function withoutTeam(world: WorldValues, index: number): WorldValues {
  const gone = world.team[index];
  const team = world.team.filter((_, i) => i !== index);
  return gone ? withGoalsOf({ ...world, team }, gone.name, null) : world;
}

function withRobots(world: WorldValues, robots: (team: TeamValues) => string[]): WorldValues {
  return { ...world, team: world.team.map((team) => ({ ...team, robots: robots(team) })) };
}

function withGoalsOf(world: WorldValues, before: string, after: string | null): WorldValues {
  const lists = Object.entries(world.goal).map(([kind, goals]) => [
    kind,
    goals.map((goal: { team: string | null }) => (goal.team === before ? { ...goal, team: after } : goal)),
  ]);
  return { ...world, goal: Object.fromEntries(lists) as WorldValues["goal"] };
}
