/** New objects of each sort, and what has to be in the world before. */

import type { Sort, Thing } from "../../views/world/plan/sorts";
import type { WorldValues, XY } from "../../views/world/scenery/description";
import { defaultsOf } from "./fields";
import type { Offer } from "./offers";

/** What a robot should not run into. */
const HARMFUL: ReadonlySet<unknown> = new Set(["bug", "ghost"]);

const LINE = 600;
const WALL = 400;

/** What a sort has besides its default values and its place; without a table, only its defaults. */
const OWN: Readonly<Partial<Record<Sort, (world: WorldValues, place: XY) => Thing>>> = {
  wall: (_, place) => ({ points: across(place, WALL) }),
  line: (_, place) => ({ points: across(place, LINE) }),
  tour: (_, place) => ({ points: across(place, WALL) }),
  prop: (_, place) => ({ ...at(place), kind: "tree" }),
  show: (_, place) => ({ ...at(place), emotion: "joy" }),
  tag: (world, place) => ({ ...at(place), heading: 180, id: freeTag(world) }),
  face: (_, place) => ({ ...at(place), heading: 180, emotion: "joy" }),
  mover: (_, place) => ({ ...at(place), wander: 200 }),
  collectable: (_, place) => ({ ...at(place), kind: "star", score: 1 }),
  switch: (world, place) => ({ ...at(place), door: world.door[0]?.name ?? defaultsOf("door").name }),
  follow: (world) => ({ line: world.line[0]?.name }),
  visit: (world) => ({ id: world.tag[0]?.id }),
  score: () => ({ points: 3 }),
  avoid: () => ({}),
  collect: () => ({}),
  gates: () => ({}),
};

/** What has to be in the world before a sort can be added. */
const NEEDED = { follow: "line", visit: "tag", switch: "door", collect: "collectable", gates: "gate" } as const;

/** A new object of a sort at a position, with default values. */
export function created(world: WorldValues, sort: Sort, place: XY): Thing {
  return { ...defaultsOf(sort), ...(OWN[sort]?.(world, place) ?? at(place)) };
}

/** An object as a kind of its sort; a robot that meets a bug or a ghost loses a life. */
export function ofKind(thing: Thing, kind: Offer["kind"]): Thing {
  if (!kind) return thing;
  return HARMFUL.has(kind) ? { ...thing, kind, score: 0, lives: -1 } : { ...thing, kind };
}

/** The sort that a new object needs and the world lacks; null if it can be created. */
export function missing(world: WorldValues, sort: Sort): Sort | null {
  if (!(sort in NEEDED)) return null;
  const needed = NEEDED[sort as keyof typeof NEEDED];
  return world[needed].length === 0 ? needed : null;
}

/** The smallest tag number that the world doesn't have. */
export function freeTag(world: WorldValues): number {
  const taken = new Set(world.tag.map(({ id }) => id));
  let id = 1;
  while (taken.has(id)) id++;
  return id;
}

function at([x, y]: XY): Thing {
  return { x, y };
}

/** The ends of a chain from west to east with this middle and length, mm. */
function across([x, y]: XY, length: number): XY[] {
  return [
    [x - length / 2, y],
    [x + length / 2, y],
  ];
}
