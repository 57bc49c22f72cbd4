/** Which dialog is open. */

import { signal } from "@preact/signals";

export type DialogName =
  | "open"
  | "examples"
  | "new"
  | "rename"
  | "saveAs"
  | "history"
  | "shortcuts"
  | "settings"
  | "worldEditor"
  | "renameWorld"
  | "blockSets"
  | "tags"
  | "robotSettings"
  | "perception"
  | "newRobot"
  | "customBlocks"
  | "libraries"
  | "containment"
  | { readonly delete: string }
  | CustomBlockDialogName;

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
