/** The sorts of objects in a world, and each object by its sort and number. */

import type { WorldValues } from "../scenery/description";

/** In the order in which they are painted and reached by Tab. */
export const SORTS = [
  "follow",
  "line",
  "reach",
  "visit",
  "tour",
  "stop",
  "show",
  "avoid",
  "start",
  "wall",
  "box",
  "cylinder",
  "prop",
  "tag",
  "face",
  "light",
] as const;
export type Sort = (typeof SORTS)[number];

/** The values of one object of any sort. */
export type Thing = Readonly<Record<string, unknown>>;

/** The `index`th object of a sort. */
export interface Ref {
  readonly sort: Sort;
  readonly index: number;
}

/** The goals of games are written by hand: the editor has no form for them. */
type GoalSort = Extract<keyof WorldValues["goal"], Sort>;
const GOALS: readonly Sort[] = ["reach", "follow", "visit", "tour", "stop", "show", "avoid"] satisfies GoalSort[];

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

export function thingAt(world: WorldValues, { sort, index }: Ref): Thing | undefined {
  return listOf(world, sort)[index];
}

export function allThings(world: WorldValues): Ref[] {
  return SORTS.flatMap((sort) => listOf(world, sort).map((_, index) => ({ sort, index })));
}
