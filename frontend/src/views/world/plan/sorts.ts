/** The sorts of objects in a world, and each object by its sort and number. */

import type { WorldValues, XY } from "../scenery/description";

type GoalSort = keyof WorldValues["goal"];

/** The goals that are painted over lines; that of following a line is under it. */
const OVER_LINES = [
  "reach",
  "visit",
  "tour",
  "stop",
  "show",
  "avoid",
  "collect",
  "gates",
  "score",
] as const satisfies GoalSort[];
const GOALS: readonly string[] = ["follow", ...OVER_LINES];

/** In the order in which they are painted and reached by Tab. */
export const SORTS = [
  "follow",
  "line",
  ...OVER_LINES,
  "zone",
  "switch",
  "start",
  "wall",
  "box",
  "cylinder",
  "prop",
  "tag",
  "face",
  "light",
  "gate",
  "door",
  "mover",
  "collectable",
] as const;
export type Sort = (typeof SORTS)[number];

/** The values of one object of any sort. */
export type Thing = Readonly<Record<string, unknown>>;

/** The `index`th object of a sort. */
export interface Ref {
  readonly sort: Sort;
  readonly index: number;
}

export function isGoal(sort: Sort): sort is GoalSort {
  return GOALS.includes(sort);
}

export function key({ sort, index }: Ref): string {
  return `${sort}:${index}`;
}

export function same(a: Ref | null, b: Ref | null): boolean {
  return a?.sort === b?.sort && a?.index === b?.index;
}

export function listOf(world: WorldValues, sort: Sort): readonly Thing[] {
  return (isGoal(sort) ? world.goal[sort] : world[sort]) as unknown as readonly Thing[];
}

/** Goals without a place, shown beside each other at the north edge of the floor. */
export const PLACELESS: readonly Sort[] = ["avoid", "collect", "gates", "score"];
/** mm between two of them, and from the edge. */
const BESIDE = 130;
const INSIDE = 60;

/** Where the sign of a goal without a place is. */
export function besideFloor(world: WorldValues, sort: Sort): XY {
  return [BESIDE * PLACELESS.indexOf(sort), world.floor.size[1] / 2 - INSIDE];
}

export function thingAt(world: WorldValues, { sort, index }: Ref): Thing | undefined {
  return listOf(world, sort)[index];
}

export function allThings(world: WorldValues): Ref[] {
  return SORTS.flatMap((sort) => listOf(world, sort).map((_, index) => ({ sort, index })));
}
