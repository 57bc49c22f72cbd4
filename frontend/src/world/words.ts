/** The world in words, for those who do not see it. */

import type { RobotValues } from "./description";
import { ahead } from "./readings";
import { t } from "../i18n";
import type { GoalNow, Robot, Telemetry } from "../messages";
import { said } from "../sentences";

const DIRECTIONS = ["e", "se", "s", "sw", "w", "nw", "n", "ne"] as const;
/** A robot that comes no nearer than this to its own axis stands in the middle, mm. */
const MIDDLE = 0.5;

/** Where it is and where it looks: "120 mm east, 300 mm north, looking north-west". */
export function placeInWords({ x, y, heading }: Pick<Robot, "x" | "y" | "heading">): string {
  return t("world.place", {
    x: along(x, "east", "west"),
    y: along(y, "north", "south"),
    direction: t(`world.direction.${directionOf(heading)}`),
  });
}

function along(way: number, positive: string, negative: string): string {
  const mm = Math.round(Math.abs(way));
  if (mm < MIDDLE) return t(`world.${positive}`, { mm: 0 });
  return t(`world.${way > 0 ? positive : negative}`, { mm });
}

function directionOf(heading: number): string {
  const eighth = Math.round(heading / 45);
  return DIRECTIONS[((eighth % 8) + 8) % 8] as string;
}

/** All that one would see of a robot at a glance. */
export function robotInWords(title: string, robot: Robot, values: RobotValues, telemetry: Telemetry): string {
  const words = [t("world.robot", { robot: title, place: placeInWords(robot) })];
  const seen = ahead(values, telemetry.sensors ?? {});
  if (seen) words.push(aheadInWords(seen));
  const emotion = robot.emotion ?? "none";
  if (emotion !== "none") words.push(t("world.emotion", { emotion: t(`world.emotion.${emotion}`) }));
  return `${words.join("; ")}.`;
}

function aheadInWords({ nearest, range }: { nearest: number | null; range: number }): string {
  if (nearest === null) return t("world.nothingAhead", { mm: Math.round(range) });
  return t("world.somethingAhead", { mm: Math.round(nearest) });
}

export function goalInWords({ name, state }: GoalNow): string {
  return t(`world.goal.${state}`, { name: said(name) });
}
