/** The blocks of games, and whether a world has one, for what the page shows only then. */

import type { WorldFile } from "../protocol/world";

/** The hats of games among the ready ones. */
export const GAME_HATS: readonly string[] = ["lb_when_collected", "lb_when_is_time_up"];

const SKILLS = [
  ...["change_score", "set_score", "show_score", "get_score", "change_lives", "set_lives", "get_lives"],
  ...["win_game", "game_over", "start_countdown", "get_time_left", "is_time_up", "collected"],
];
/** The types of all blocks of games. */
export const GAME_BLOCKS: ReadonlySet<string> = new Set([...GAME_HATS, ...SKILLS.map((name) => `lb_skill_${name}`)]);

/** Whether there is something in a world that makes a score, lives or a countdown. */
export function hasGame(world: Partial<WorldFile> | undefined): boolean {
  const things = [world?.collectable, world?.zone, world?.gate, world?.mover, world?.switch];
  return Boolean(world?.game) || things.some((list) => list && list.length > 0);
}
