/** Which dialog is open. */

import { signal } from "@preact/signals";

export type DialogName =
  | "open"
  | "examples"
  | "saveAs"
  | "history"
  | "shortcuts"
  | "settings"
  | "worldEditor"
  | { readonly delete: string };

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
