/** What the gallery says of worlds, and which of them it shows. */

import { t, worldName } from "../../i18n";
import { deviceWord, plainTitle } from "../../model/robots";
import type { RobotChoice, WorldChoice } from "../../protocol/messages";
import type { IconName } from "../../ui/icons";
import { plain } from "../../ui/plain";

export type Group = NonNullable<WorldChoice["group"]>;

/** The groups in the order of the gallery. */
export const GROUPS: readonly (readonly [Group, IconName])[] = [
  ["games", "game"],
  ["drive", "move"],
  ["obstacles", "prop_cone"],
  ["lines", "trail"],
  ["tags", "camera"],
  ["faces", "show"],
  ["several", "teachers"],
  ["empty", "empty"],
];

const LEVELS = ["easy", "medium", "tricky"] as const;

/** How many of three dots are filled; 0 if the difficulty is unknown. */
export function dots({ difficulty }: WorldChoice): number {
  return difficulty ? LEVELS.indexOf(difficulty) + 1 : 0;
}

export function groupOf({ group = "drive" }: WorldChoice): Group {
  return group;
}

/** What to do in a world; empty if that is its title. */
export function goalOf({ title, own }: WorldChoice): string {
  const goal = worldName(title);
  // The name of the world is above it.
  return own ? "" : capital(goal.replace(/^[^:]{1,24}: /, ""));
}

/** What a robot lacks to reach the goals of a world. */
export function lacking({ needs = [] }: WorldChoice, robot: RobotChoice | undefined): readonly string[] {
  return needs.filter((need) => robot?.lacks?.includes(need));
}

/** The simulated robots that can reach the goals of a world. */
export function able(world: WorldChoice, robots: readonly RobotChoice[]): readonly RobotChoice[] {
  return robots.filter((robot) => robot.simulated && lacking(world, robot).length === 0);
}

/** Why a robot can't reach the goals of a world, in words; empty if it can. */
export function reason(world: WorldChoice, robots: readonly RobotChoice[], robot: RobotChoice | undefined): string {
  const [need] = lacking(world, robot);
  if (!need) return "";
  const names = able(world, robots).map(plainTitle);
  return t("page-gallery-needs", { what: deviceWord(need), robots: names.join(", ") });
}

/** Worlds with words in their title, goal, group or difficulty, those that the robot can't solve last. */
export function searched(
  worlds: readonly WorldChoice[],
  words: string,
  robot: RobotChoice | undefined,
  titleOf: (name: string) => string,
): readonly WorldChoice[] {
  const wanted = plain(words).split(/\s+/).filter(Boolean);
  const matching = worlds.filter((world) => {
    const text = plain([titleOf(world.name), worldName(world.title), ...filedUnder(world)].join(" "));
    return wanted.every((word) => text.includes(word));
  });
  return [...matching].sort((one, other) => order(one, robot) - order(other, robot) || compare(one, other));

  function compare(one: WorldChoice, other: WorldChoice): number {
    return dots(one) - dots(other) || titleOf(one.name).localeCompare(titleOf(other.name));
  }
}

function order(world: WorldChoice, robot: RobotChoice | undefined): number {
  return lacking(world, robot).length > 0 ? 1 : 0;
}

function filedUnder(world: WorldChoice): readonly string[] {
  const { difficulty } = world;
  return [t(`page-gallery-group-${groupOf(world)}`), difficulty ? t(`page-gallery-${difficulty}`) : ""];
}

function capital(text: string): string {
  return text.slice(0, 1).toUpperCase() + text.slice(1);
}
