/** Adds a robot to a program that uses one but says `without robot`: removes that line from its Block-Text. */

import type { Problem } from "../protocol/messages";
import type { Program } from "./program";

const CODES: ReadonlySet<string> = new Set(["check-without-robot", "python-no-robot"]);
const WITHOUT_ROBOT = /^without[ \t]+robot\b.*\n+/m;

/** Whether a problem is a missing robot that can be added here. */
export function canAddRobot(program: Program, { message }: Pick<Problem, "message">): boolean {
  const { blocktext, stale } = program.state.value;
  const saysSo = !stale.includes("blocktext") && WITHOUT_ROBOT.test(blocktext);
  return CODES.has(message.code) && saysSo && !program.readOnly.value;
}

export function addRobot(program: Program): void {
  const { blocktext } = program.state.peek();
  program.editedText("blocktext", () => blocktext.replace(WITHOUT_ROBOT, ""));
}
