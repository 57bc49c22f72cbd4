/** Whether a program plays a game. */

import { GAME_BLOCKS } from "../../model/games";
import type { Workspace } from "../../protocol/messages";
import { blocksIn } from "./folds";

export function usesGame({ stacks }: Workspace): boolean {
  for (const { type } of blocksIn(stacks.flat())) if (GAME_BLOCKS.has(type)) return true;
  return false;
}
