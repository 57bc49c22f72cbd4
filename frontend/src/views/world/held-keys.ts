/** The keys that the user holds down for the running programs, while the world has the focus. */

import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";

import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { HoldKeys } from "../../protocol/messages";

export type Key = HoldKeys["keys"][number];

/** From this number on, the keys are not listed one by one. */
const MANY = 12;
const NAMED: Readonly<Record<string, Key>> = {
  ArrowUp: "up",
  ArrowDown: "down",
  ArrowLeft: "left",
  ArrowRight: "right",
  " ": "space",
  Enter: "enter",
};
const ARROWS: Partial<Record<Key, string>> = { up: "↑", down: "↓", left: "←", right: "→" };

/** The programs' name for a key that is pressed, if one of them asks for it. */
export function keyOf({ key }: Pick<KeyboardEvent, "key">, wanted: readonly Key[]): Key | undefined {
  const name = NAMED[key] ?? key.toLowerCase();
  return wanted.find((one) => one === name);
}

/** The keys in words, or symbols. */
export function describeKeys(keys: readonly Key[]): string {
  if (keys.length >= MANY) return t("page-world-keys-all");
  return keys.map((key) => ARROWS[key] ?? (key.length > 1 ? t(`page-world-key-${key}`) : key.toUpperCase())).join(" ");
}

export class HeldKeys {
  /** A sentence about the keys that the programs ask for; empty if they ask for none. */
  readonly hint: ReadonlySignal<string>;
  private readonly focused = signal(false);
  /** By the place of the key, as Shift may be pressed or released meanwhile. */
  private readonly held = new Map<string, Key>();
  private readonly listening = new AbortController();
  private readonly end: () => void;

  /** `frame`: the part of the page that must have the focus. */
  constructor(
    private readonly frame: HTMLElement,
    private readonly context: Context,
  ) {
    const { keys, listeners } = context.running;
    this.hint = computed(() => {
      if (keys.value.length === 0) return "";
      const word = this.focused.value ? "page-world-keys-heard" : "page-world-keys-wanted";
      return t(word, { keys: describeKeys(keys.value), programs: listeners.value });
    });
    this.end = effect(() => (keys.value.length > 0 ? this.begin() : this.held.clear()));
    const { signal: until } = this.listening;
    // Before the keys of the world's own tools.
    frame.addEventListener("keydown", (event) => this.press(event), { capture: true, signal: until });
    frame.addEventListener("focusin", () => this.focus(true), { signal: until });
    frame.addEventListener("focusout", () => this.focus(false), { signal: until });
    addEventListener("keyup", (event) => this.release(event), { signal: until });
    addEventListener("blur", () => this.releaseAll(), { signal: until });
  }

  destroy(): void {
    this.releaseAll();
    this.listening.abort();
    this.end();
  }

  /** The program has begun to listen: take the focus, unless the user is somewhere else by now. */
  private begin(): void {
    const at = document.activeElement;
    if (at === null || at === document.body || at.closest("[data-region=bar], .run-bar"))
      this.frame.focus({ preventScroll: true });
  }

  private focus(on: boolean): void {
    this.focused.value = on;
    if (!on) this.releaseAll();
  }

  private press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = keyOf(event, this.context.running.keys.peek());
    if (!key) return;
    event.preventDefault();
    event.stopPropagation();
    // A repeated key has perhaps been down since before the program listened.
    if (this.held.get(event.code) === key) return;
    this.held.set(event.code, key);
    this.send();
  }

  private release(event: KeyboardEvent): void {
    if (this.held.delete(event.code)) this.send();
  }

  private releaseAll(): void {
    if (this.held.size === 0) return;
    this.held.clear();
    this.send();
  }

  private send(): void {
    this.context.connection.send({ kind: "HoldKeys", keys: [...new Set(this.held.values())] });
  }
}
