/** How a game ended, and whose goals there are, in words. */

import { t, worldName } from "../i18n";
import type { GameNow, GoalNow } from "../protocol/messages";

/** How a game that is over ended: "Red wins", "You win", "Time is up". */
export function endOf({ won, reason, winner, team, players }: GameNow): string {
  if (won && team) return t("page-world-game-team-wins", { team: worldName(team) });
  if (won && winner && players.length > 1) return t("page-world-game-robot-wins", { robot: winner });
  if (won) return t("page-world-game-won");
  return t(reason === "time" ? "page-world-game-time-up" : "page-world-game-over");
}

/** The goal that won a game, with the robot that reached it for its team; null where none did. */
export function winningGoal({ reason, winner, team }: GameNow, goals: readonly GoalNow[]): string | null {
  if (!winner || !goals.some(({ name }) => name === reason)) return null;
  const goal = worldName(reason ?? "");
  return team ? t("page-world-game-goal-by", { goal, robot: winner }) : goal;
}

/** A goal with its team: "ball in the east goal (Red)". */
export function goalName({ name, team }: Pick<GoalNow, "name" | "team">): string {
  const goal = worldName(name);
  return team ? t("page-world-goal-of-team", { team: worldName(team), goal }) : goal;
}

/** The goals of a robot: its team's, and those of all. */
export function goalsOf(robot: string | undefined, goals: readonly GoalNow[], game?: GameNow | null): GoalNow[] {
  const own = game?.players.find(({ name }) => name === robot)?.team;
  return goals.filter(({ team }) => !team || !own || team === own);
}
