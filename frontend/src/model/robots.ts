/** The robots as the user chooses them. */

import { t, translated } from "../i18n";
import type { RobotChoice } from "../protocol/messages";

/** Robots in other simulators; LearnBlock connects to them as to real robots. */
const OTHER_SIMULATORS: ReadonlySet<string> = new Set(["coppeliasim", "rcis"]);

export interface RobotGroup {
  readonly name: "simulated" | "real";
  readonly robots: readonly RobotChoice[];
}

/** The simulated and the real robots, each in the server's order; a group without robots is left out. */
export function robotGroups(robots: readonly RobotChoice[]): readonly RobotGroup[] {
  const groups: readonly RobotGroup[] = [
    { name: "simulated", robots: robots.filter((one) => !isReal(one)) },
    { name: "real", robots: robots.filter(isReal) },
  ];
  return groups.filter((group) => group.robots.length > 0);
}

/** A robot's display name, which tells a real robot from its twin. */
export function robotTitle(robot: RobotChoice): string {
  const title = plainTitle(robot);
  return isReal(robot) ? t("page-bar-real-robot", { robot: title }) : title;
}

/** The display name where all robots are real. */
export function plainTitle({ name, title }: RobotChoice): string {
  return translated(`page-catalog-robot-${name}`, title);
}

function isReal({ name, simulated }: RobotChoice): boolean {
  return !simulated && !OTHER_SIMULATORS.has(name);
}
