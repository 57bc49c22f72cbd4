/** The buttons above a text, for use without a keyboard. */

import type { EditorView } from "@codemirror/view";
import { effect } from "@preact/signals";

import { t } from "../../i18n";
import { icon } from "../../ui/icons";
import type { Island } from "../../ui/island";
import type { Action, ActionName, TextActions } from "./actions";

/** Undo and redo are the page's, which has buttons for them. */
const SHOWN: readonly ActionName[] = ["find", "format", "breakpoint", "help", "definition", "rename", "reveal", "why"];

/** A key as printed on keyboards: `Shift-Alt-f` becomes Shift+Alt+F. */
function keyName(key: string): string {
  const mac = /Mac|iP(hone|ad)/.test(navigator.platform);
  return key
    .split("-")
    .map((part) => (part === "Mod" ? (mac ? "⌘" : "Ctrl") : part.length === 1 ? part.toUpperCase() : part))
    .join("+");
}

function makeButton(action: Action, view: EditorView): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.dataset.action = action.name;
  button.append(icon(action.name));
  button.tabIndex = -1;
  button.onmousedown = (event) => event.preventDefault();
  button.onclick = () => {
    view.focus();
    action.run(view);
  };
  return button;
}

function name(button: HTMLButtonElement, action: Action): void {
  const label = t(`page-text-${action.name}`);
  button.setAttribute("aria-label", label);
  button.title = `${label} (${action.keys.map(keyName).join(", ")})`;
}

/** Arrow keys move between the buttons, so Tab passes all of them in one step. */
function rove(bar: HTMLElement): void {
  bar.onkeydown = (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const buttons = [...bar.querySelectorAll("button")];
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const next = buttons[(at + step + buttons.length) % buttons.length];
    for (const button of buttons) button.tabIndex = button === next ? 0 : -1;
    next?.focus();
    event.preventDefault();
  };
}

export function createToolbar(actions: TextActions, view: EditorView): Island {
  const dom = document.createElement("div");
  dom.className = "text-toolbar";
  dom.setAttribute("role", "toolbar");
  const shown = actions.all.filter((action) => SHOWN.includes(action.name));
  const buttons = shown.map((action) => [makeButton(action, view), action] as const);
  dom.append(...buttons.map(([button]) => button));
  if (buttons[0]) buttons[0][0].tabIndex = 0;
  rove(dom);
  const dispose = effect(() => {
    dom.setAttribute("aria-label", t("page-text-toolbar"));
    for (const [button, action] of buttons) name(button, action);
  });
  return { dom, destroy: dispose };
}
