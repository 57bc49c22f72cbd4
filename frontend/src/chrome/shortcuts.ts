/** The page's keys. */

import { t } from "../i18n";
import type { Page } from "./page";
import { nextRegion } from "./regions";

/** A key that works everywhere on the page; its letter is the one that `KeyboardEvent.key` gives. */
export interface Shortcut {
  readonly key: string;
  readonly control?: boolean;
  readonly shift?: boolean;
  /** What it does, as a key of the translations. */
  readonly word: string;
  run(page: Page): void;
}

// Free of what Blockly (letters), CodeMirror (F2, F8, F12 and more) and browsers keep for themselves.
export const SHORTCUTS: readonly Shortcut[] = [
  { key: "Enter", control: true, word: "bar.run", run: ({ controls }) => controls.run() },
  { key: "Enter", control: true, shift: true, word: "bar.stop", run: ({ controls }) => controls.stop() },
  { key: "F4", word: "bar.pauseOrResume", run: ({ controls }) => controls.pauseOrResume() },
  { key: "F7", word: "bar.step", run: ({ controls }) => controls.step(false) },
  { key: "F10", word: "bar.stepOver", run: ({ controls }) => controls.step(true) },
  { key: "F6", word: "settings.nextRegion", run: (page) => nextRegion(page.views, 1) },
  { key: "F6", shift: true, word: "settings.previousRegion", run: (page) => nextRegion(page.views, -1) },
  { key: "o", control: true, word: "project.open", run: ({ dialogs }) => dialogs.show("open") },
  { key: "s", control: true, word: "settings.saves", run: saves },
  { key: "F1", word: "settings.shortcuts", run: ({ dialogs }) => dialogs.show("shortcuts") },
];

/** Keys that work in a part of the page, for the dialog that lists all: keys, and what they do. */
export const OTHER_KEYS: Readonly<Record<string, readonly (readonly [string, string])[]>> = {
  "settings.everywhere": [
    ["Ctrl+Z", "bar.undo"],
    ["Ctrl+Shift+Z, Ctrl+Y", "bar.redo"],
    ["F9", "settings.breakpoint"],
    ["Esc", "settings.closes"],
  ],
  "chrome.blocks": [
    ["T", "settings.toolbox"],
    ["Ctrl+B", "blocks.search_blocks"],
    ["W", "settings.workspace"],
    ["←↑↓→", "settings.moveCursor"],
    ["Enter", "settings.editBlock"],
    ["M", "settings.moveBlock"],
    ["D", "settings.duplicate"],
    ["Delete", "settings.delete"],
    ["Ctrl+F", "settings.search"],
  ],
  "settings.texts": [
    ["Ctrl+Space", "settings.complete"],
    ["Ctrl+I", "settings.describe"],
    ["F8", "settings.nextProblem"],
    ["F2", "settings.rename"],
    ["F12", "settings.definition"],
    ["Shift+Alt+F", "settings.format"],
    ["Alt+Enter", "settings.reveal"],
    ["Ctrl+F", "settings.search"],
    ["Esc, Tab", "settings.leaves"],
  ],
};

/** As a person reads it. */
export function keysOf({ key, control, shift }: Shortcut): string {
  const name = key.length === 1 ? key.toUpperCase() : key;
  return [control ? "Ctrl" : "", shift ? "Shift" : "", name].filter(Boolean).join("+");
}

/** The keys of what a button does. */
export function keysFor(word: string): string | undefined {
  const found = SHORTCUTS.find((one) => one.word === word);
  return found && keysOf(found);
}

/** Listen to the page's keys until what is returned is called. */
export function listen(page: Page): () => void {
  const pressed = (event: KeyboardEvent) => {
    const shortcut = SHORTCUTS.find((one) => matches(one, event));
    if (!shortcut || page.dialogs.open.value !== null || page.dialogs.tour.value) return;
    event.preventDefault();
    event.stopPropagation();
    shortcut.run(page);
  };
  const unclaimed = (event: KeyboardEvent) => undoOrRedo(page, event);
  // Before the views: an editor would take Ctrl+Enter for a new line.
  addEventListener("keydown", pressed, { capture: true });
  addEventListener("keydown", unclaimed);
  return () => {
    removeEventListener("keydown", pressed, { capture: true });
    removeEventListener("keydown", unclaimed);
  };
}

function matches(shortcut: Shortcut, event: KeyboardEvent): boolean {
  return (
    event.key.toLowerCase() === shortcut.key.toLowerCase() &&
    (event.ctrlKey || event.metaKey) === (shortcut.control ?? false) &&
    event.shiftKey === (shortcut.shift ?? false) &&
    !event.altKey
  );
}

/** Where no view has taken the key, it is the program's all the same. */
function undoOrRedo({ context: { program } }: Page, event: KeyboardEvent): void {
  if (event.defaultPrevented || !(event.ctrlKey || event.metaKey) || isField(event.target)) return;
  const key = event.key.toLowerCase();
  if (key === "z" && !event.shiftKey) program.undo();
  else if (key === "y" || key === "z") program.redo();
}

function isField(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches("input, textarea"));
}

function saves({ context: { program }, toasts }: Page): void {
  program.flush();
  toasts.note(t("project.savesItself"));
}
