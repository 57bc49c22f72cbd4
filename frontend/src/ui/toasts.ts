/** Short notes over the page that disappear on their own. */

import { signal } from "@preact/signals";

export interface Toast {
  readonly sort: "note" | "error";
  readonly text: string;
  readonly action?: { readonly text: string; run(): void };
}

const MOST = 4;
/** Errors stay until the user dismisses them. */
const NOTE_STAYS = 6000;

export class Toasts {
  readonly shown = signal<readonly Toast[]>([]);

  show(toast: Toast): void {
    const others = this.shown.value.filter((one) => one.text !== toast.text);
    this.shown.value = [...others, toast].slice(-MOST);
    if (toast.sort === "note") setTimeout(() => this.dismiss(toast), NOTE_STAYS);
  }

  note(text: string): void {
    this.show({ sort: "note", text });
  }

  error(text: string): void {
    this.show({ sort: "error", text });
  }

  dismiss(toast: Toast): void {
    this.shown.value = this.shown.value.filter((one) => one !== toast);
  }
}
