/** Whether a program and its world have a game, for what the page shows only then. */

import type { Workspace } from "../protocol/messages";
import type { WorldFile } from "../protocol/world";

/** The hats of games among the ready ones. */
export const GAME_HATS: readonly string[] = ["lb_when_collected", "lb_when_is_time_up"];

const NAMES = [
  ...["change_score", "set_score", "show_score", "get_score", "change_lives", "set_lives", "get_lives"],
  ...["win_game", "game_over", "start_countdown", "get_time_left", "is_time_up", "collected"],
];
const BLOCKS = new RegExp(`"type":"lb_(?:skill|when)_(?:${NAMES.join("|")})"`);

/** Whether there is something in a world that makes a score, lives or a countdown. */
export function hasGame(world: Partial<WorldFile> | undefined): boolean {
  const things = [world?.collectable, world?.zone, world?.gate, world?.mover, world?.switch];
  return Boolean(world?.game) || things.some((list) => list && list.length > 0);
}

/** Whether a program has blocks of games. */
export function usesGame(program: Workspace): boolean {
  return BLOCKS.test(JSON.stringify(program));
}
