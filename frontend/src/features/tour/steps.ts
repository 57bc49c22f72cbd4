/** The steps of the tour: in each, the user does something, and the page notices. */

import type { Page } from "../../model/page";
import { VIEWS } from "../../model/views";

export interface Step {
  readonly name: "add" | "change" | "run" | "texts" | "robot";
  /** Whether it has no button that passes over it: without a block there is nothing to change or run. */
  readonly mustBeDone?: true;
  /** The value of `data-tour`; of several elements, the first visible one. */
  readonly target: string;
  /** Whether the user has done it since the step began. */
  isDone(now: Moment, before: Moment): boolean;
}

/** What the steps compare. */
export interface Moment {
  readonly statements: number;
  readonly text: string;
  readonly runs: boolean;
  readonly shown: string;
  readonly robot: string;
}

export const STEPS: readonly Step[] = [
  {
    name: "add",
    target: "blocks",
    mustBeDone: true,
    isDone: (now, before) => now.statements > before.statements,
  },
  {
    name: "change",
    target: "blocks",
    isDone: (now, before) => now.statements === before.statements && now.text !== before.text,
  },
  { name: "run", target: "run", isDone: (now, before) => now.runs && !before.runs },
  { name: "texts", target: "areas", isDone: (now, before) => now.shown !== before.shown },
  { name: "robot", target: "robot", isDone: (now, before) => now.robot !== before.robot },
];

export function momentOf({ context: { program, running }, views }: Page): Moment {
  const { places, blocktext } = program.state.value;
  return {
    statements: places.length,
    text: blocktext,
    runs: running.active.value,
    shown: VIEWS.filter((view) => views.shows(view)).join(),
    robot: running.robot.value,
  };
}
