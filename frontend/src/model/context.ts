/** The objects that every part of the page can use. */

import type { ReadonlySignal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { BlockSet, CustomBlock, Problem, Robot, RobotChoice, View } from "../protocol/messages";
import type { AskingWhy } from "./asking-why";
import type { Way } from "./kept-runs";
import type { LookingBack } from "./looking-back";
import type { Program } from "./program";
import type { Running } from "./running";

export interface Context {
  readonly connection: Connection;
  readonly program: Program;
  readonly running: Running;
  /** The view of the program that mistakes are shown in: the one that was edited last, if it is open. */
  readonly openView: ReadonlySignal<View>;
  /** The error of the last run, as a problem in each view. */
  readonly runError: ReadonlySignal<readonly Problem[]>;
  /** The robots to choose. */
  readonly robots: ReadonlySignal<readonly RobotChoice[]>;
  /** The custom blocks; null until the server has sent them. */
  readonly customBlocks: ReadonlySignal<readonly CustomBlock[] | null>;
  /** The set of blocks that the palette shows. */
  readonly shownBlocks: ReadonlySignal<BlockSet>;
  /** The ways of the runs that are compared, or of a real robot and its twin; none if none are. */
  readonly ways: ReadonlySignal<readonly Way[]>;
  /** Where the twin of a real robot would have been at the moment that is shown; null without one. */
  readonly ghost: ReadonlySignal<Robot | null>;
  /** The tag dictionary: the number of each name. */
  readonly tagNames: ReadonlySignal<Readonly<Record<string, number>>>;
  /** The block that the teacher's note on what came back is about; null without one. */
  readonly noted: ReadonlySignal<string | null>;
  /** Shows a statement, given by its block's id, in every view. */
  reveal(block: string): void;
  /** Shows a problem in its view, and a statement as that view shows it. */
  goTo(problem: Problem): void;
  describeStep(view: View, block: string): string;
  /** Reports the statement, given by its block's id, that the user has selected in a view; null without one. */
  select(block: string | null): void;
  /** The colour of a robot's tab; null if the project has only one robot. */
  robotColor(name: string): string | null;
  /** Goes to other moments of the last run. */
  readonly lookingBack: LookingBack;
  /** Questions about the last run. */
  readonly askingWhy: AskingWhy;
  /** Opens the dialog for a block that the program defines, by its definition; a new one if that is empty. */
  makeBlock(definition: string): void;
  /** Opens the list of custom blocks. */
  listCustomBlocks(): void;
  /** Open a program in Block-Text as a project. */
  openExample(program: string): void;
  /** Opens a custom block at a line of its source, from 1; a new one if the name is empty. */
  editCustomBlock(name: string, line?: number): void;
}
