/** Descriptions of the world, for screen readers. */

import { t } from "../../i18n";
import { goalName } from "../../model/game-words";
import type { GoalNow, Robot, Telemetry } from "../../protocol/messages";
import type { RobotValues } from "./scenery/description";
import { ahead } from "./scenery/readings";

const DIRECTIONS = ["e", "se", "s", "sw", "w", "nw", "n", "ne"] as const;
/** A coordinate smaller than this counts as the middle, mm. */
const MIDDLE = 0.5;

/** A position and heading in words: "120 mm east, 300 mm north, looking north-west". */
export function placeInWords({ x, y, heading }: Pick<Robot, "x" | "y" | "heading">): string {
  return t("page-world-place", {
    x: along(x, "east", "west"),
    y: along(y, "north", "south"),
    direction: t(`page-world-direction-${directionOf(heading)}`),
  });
}

function along(way: number, positive: string, negative: string): string {
  const mm = Math.round(Math.abs(way));
  if (mm < MIDDLE) return t(`page-world-${positive}`, { mm: 0 });
  return t(`page-world-${way > 0 ? positive : negative}`, { mm });
}

function directionOf(heading: number): string {
  const eighth = Math.round(heading / 45);
  return DIRECTIONS[((eighth % 8) + 8) % 8] as string;
}

/** A short description of a robot. */
export function robotInWords(title: string, robot: Robot, values: RobotValues, telemetry: Telemetry): string {
  const words = [
    robot.located === false
      ? t("page-link-robot-unlocated", { robot: title })
      : t("page-world-robot", { robot: title, place: placeInWords(robot) }),
  ];
  const seen = ahead(values, telemetry.sensors ?? []);
  if (seen) words.push(aheadInWords(seen));
  const emotion = robot.emotion ?? "none";
  if (emotion !== "none") words.push(t("page-world-emotion", { emotion: t(`page-world-emotion-${emotion}`) }));
  if (robot.text) words.push(t("page-world-text", { text: robot.text }));
  return `${words.join("; ")}.`;
}

function aheadInWords({ nearest, range }: { nearest: number | null; range: number }): string {
  if (nearest === null) return t("page-world-nothing-ahead", { mm: Math.round(range) });
  return t("page-world-something-ahead", { mm: Math.round(nearest) });
}

export function goalInWords(goal: GoalNow): string {
  return t(`page-world-goal-${goal.state}`, { name: goalName(goal) });
}
