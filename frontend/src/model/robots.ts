/** The robots as the user chooses them. */

import { say, t, translated } from "../i18n";
import type { RobotChoice } from "../protocol/messages";

/** Robots in other simulators; LearnBlock connects to them as to real robots. */
export const OTHER_SIMULATORS: ReadonlySet<string> = new Set(["coppeliasim", "rcis"]);

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

/** A robot's display name, which tells a real robot from its twin; the user may have given it another. */
export function robotTitle(robot: RobotChoice): string {
  const title = plainTitle(robot);
  if (robot.given) return t("page-bar-named-robot", { name: robot.given, robot: title });
  return isReal(robot) ? t("page-bar-real-robot", { robot: title }) : title;
}

/** The display name where all robots are real. */
export function plainTitle({ name, title }: RobotChoice): string {
  return translated(`page-catalog-robot-${name}`, title);
}

/** The real robot that a robot is or whose twin it is. */
export function realOf(name: string, real: readonly RobotChoice[]): RobotChoice | undefined {
  return real.find((one) => one.name === name) ?? real.find((one) => `sim-${one.name}` === name);
}

/** What a block needs, a sense or a device, as a noun phrase. */
export function deviceWord(need: string): string {
  const [kind = "", key = ""] = need.split(":");
  return say({ code: "check-device", values: { kind, key } });
}

/** The device that the computer with the page replaces if the robot has none. */
export const STOOD_IN = "Speaker";

/** Whether this computer does it for a robot that can't. */
export function isStoodIn(need: string): boolean {
  return need.split(":")[0] === STOOD_IN;
}

/** What serves the senses among some needs on a robot, as a sentence; empty if they have no sense that it has. */
export function servingWords({ serves = {} }: RobotChoice, needs: readonly string[]): string {
  const ways = new Set(needs.flatMap((need) => serves[need] ?? []));
  const devices = [...ways].map((way) => {
    const [kind = "", key = ""] = way.split(":");
    return { code: "check-serving-device", values: { kind, key } };
  });
  return devices.length ? say({ code: "check-serving", values: { devices } }) : "";
}

function isReal({ name, simulated }: RobotChoice): boolean {
  return !simulated && !OTHER_SIMULATORS.has(name);
}

/** Whether a robot is one of LearnBlock's own twins. */
export function isTwin({ simulated, ours = false }: RobotChoice): boolean {
  return simulated && ours;
}

/** Whether real robots can be used; pupils of a class have simulated ones only. */
export function hasReal(robots: readonly RobotChoice[]): boolean {
  return robots.some(({ simulated }) => !simulated);
}
