/** How a robot is called. */

import type { Listed } from "../../model/connect";
import { plainTitle } from "../../model/robots";
import type { RobotChoice } from "../../protocol/messages";

/** The kind of a robot in words. */
export function kindTitle(robots: readonly RobotChoice[], robot: string): string {
  const choice = robots.find((one) => one.name === robot);
  return plainTitle(choice ?? { name: robot, title: robot, simulated: false });
}

/** A robot's own name, or its kind. */
export function titleOf(robots: readonly RobotChoice[], { name, robot }: Listed): string {
  return name || kindTitle(robots, robot);
}
