/** Short notes over the page that disappear on their own. */

import { effect, signal } from "@preact/signals";

export interface Toast {
  readonly sort: "note" | "error";
  readonly text: string;
  readonly action?: { readonly text: string; run(): void };
}

const MOST = 4;
/** Errors stay until the user dismisses them or they are fixed; so do notes with an action. */
const NOTE_STAYS = 6000;

export class Toasts {
  readonly shown = signal<readonly Toast[]>([]);

  show(toast: Toast): void {
    const others = this.shown.value.filter((one) => one.text !== toast.text);
    this.shown.value = [...others, toast].slice(-MOST);
    if (toast.sort === "note" && !toast.action) setTimeout(() => this.dismiss(toast), NOTE_STAYS);
  }

  note(text: string): void {
    this.show({ sort: "note", text });
  }

  error(text: string): void {
    this.show({ sort: "error", text });
  }

  /** Show an error until `fixed`, which reads signals, is true. */
  errorUntil(fixed: () => boolean, text: string): void {
    const toast = { sort: "error", text } as const;
    this.show(toast);
    const end = effect(() => {
      if (!fixed() && this.shown.value.includes(toast)) return;
      // After this turn, because an effect cannot be stopped while it is being created.
      queueMicrotask(() => {
        end();
        this.dismiss(toast);
      });
    });
  }

  dismiss(toast: Toast): void {
    this.shown.value = this.shown.value.filter((one) => one !== toast);
  }
}
