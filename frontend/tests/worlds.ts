import { isGoal, SORTS } from "../src/views/world/plan/sorts";
import type { WorldValues } from "../src/views/world/scenery/description";

/** A world without objects. */
export function emptyWorld(): WorldValues {
  const lists = Object.fromEntries(SORTS.filter((sort) => !isGoal(sort)).map((sort) => [sort, []]));
  const floor = { size: [2000, 1000], colour: "white", border: 0 };
  return {
    title: "",
    floor,
    ...lists,
    goal: Object.fromEntries(SORTS.filter(isGoal).map((sort) => [sort, []])),
    game: null,
    team: [],
  } as unknown as WorldValues;
}
