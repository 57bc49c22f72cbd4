/** Which dialog is open. */

import { signal } from "@preact/signals";

export type DialogName =
  | "open"
  | "examples"
  | "new"
  | "rename"
  | "saveAs"
  | "history"
  | "moreOfProject"
  | "openLink"
  | "share"
  | "programPicture"
  | "help"
  | "shortcuts"
  | "settings"
  | "worldEditor"
  | "worlds"
  | "addRobots"
  | "invite"
  | "robotCount"
  | "renameRobot"
  | "worldVariant"
  | "blockSets"
  | "tags"
  | "robotSettings"
  | "connect"
  | "perception"
  | "newRobot"
  | "customBlocks"
  | "libraries"
  | "containment"
  | "otherDevice"
  | "callsBeside"
  | "grading"
  | "lessonEditor"
  | ProjectDialogName
  | WorldDialogName
  | LessonDialogName
  | RunDialogName
  | ShowDialogName
  | MakeBlockDialogName
  | CustomBlockDialogName;

/** A question about a project, which need not be open, by its name. */
export type ProjectDialogName = { readonly delete: string } | { readonly rename: string } | { readonly copy: string };

/** A world by its name: to change it or its title. */
export type WorldDialogName = { readonly editWorld: string } | { readonly renameWorld: string };

/** A lesson by its name: the question whether to delete it, or what it has for the teacher. */
export type LessonDialogName =
  | { readonly deleteLesson: string; readonly title: string }
  | { readonly lessonNotes: string; readonly title: string };

/** A question about a kept run, by its id. */
export type RunDialogName = { readonly nameRun: string } | { readonly deleteRun: string };

/** The choice of a classmate who is to see the project of a link. */
export interface ShowDialogName {
  readonly showLink: string;
}

/** A block that the program defines, by its definition; empty for a new one. */
export interface MakeBlockDialogName {
  readonly makeBlock: string;
}

/** A custom block by its name, which is empty for a new one, and a line of its source from 1. */
export interface CustomBlockDialogName {
  readonly customBlock: string;
  readonly line: number;
}

export class Dialogs {
  readonly open = signal<DialogName | null>(null);
  readonly tour = signal(false);

  show(name: DialogName): void {
    this.open.value = name;
  }

  close(): void {
    this.open.value = null;
  }
}
