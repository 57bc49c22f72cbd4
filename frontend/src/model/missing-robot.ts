/** Adds a robot to a program that uses one and has none: in Block-Text, a line less. */

import type { Problem } from "../protocol/messages";
import type { Program } from "./program";

const CODES: ReadonlySet<string> = new Set(["check-without-robot", "python-no-robot"]);
const WITHOUT_ROBOT = /^without[ \t]+robot\b.*\n+/m;

/** Whether a mistake is that the program uses a robot and has none, and a robot can be added here. */
export function canAddRobot(program: Program, { message }: Pick<Problem, "message">): boolean {
  const { blocktext, stale } = program.state.value;
  const isShown = !stale.includes("blocktext") && WITHOUT_ROBOT.test(blocktext);
  return CODES.has(message.code) && isShown && !program.readOnly.value;
}

export function addRobot(program: Program): void {
  const { blocktext } = program.state.peek();
  program.editedText("blocktext", () => blocktext.replace(WITHOUT_ROBOT, ""));
}
