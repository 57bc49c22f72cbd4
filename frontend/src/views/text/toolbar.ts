/** The buttons above a text, for use without a keyboard. */

import type { EditorView } from "@codemirror/view";
import { effect } from "@preact/signals";

import { t } from "../../i18n";
import type { Island } from "../../ui/island";
import type { Action, ActionName, Actions } from "./actions";

/** Paths in a square of 24, drawn as lines. */
const ICONS: Record<ActionName, string> = {
  undo: "M9 7 4 12l5 5M4 12h10a5 5 0 0 1 0 10h-2",
  redo: "m15 7 5 5-5 5M20 12H10a5 5 0 0 0 0 10h2",
  find: "M10.5 4a6.5 6.5 0 1 1 0 13 6.5 6.5 0 0 1 0-13Zm5 11.500 5 5",
  format: "M4 6h16M8 11h12M8 16h12M4 21h16",
  breakpoint: "M12 6a6 6 0 1 1 0 12 6 6 0 0 1 0-12Z",
  help: "M9 9a3 3 0 1 1 4.500 2.600c-1 .6-1.500 1.200-1.500 2.400M12 17.500v.1M12 3a9 9 0 1 1 0 18 9 9 0 0 1 0-18Z",
  definition: "M4 12h13M12 6l6 6-6 6M21 5v14",
  rename: "m4 20 1-4L16 5l3 3L8 19l-4 1Zm9-12 3 3",
  reveal: "M3 12s3.500-6 9-6 9 6 9 6-3.500 6-9 6-9-6-9-6Zm9-2.500a2.500 2.500 0 1 1 0 5 2.500 2.500 0 0 1 0-5Z",
};

/** Undo and redo are the page's, which has buttons for them. */
const SHOWN: readonly ActionName[] = ["find", "format", "breakpoint", "help", "definition", "rename", "reveal"];

const SVG = "http://www.w3.org/2000/svg";

function icon(name: ActionName): SVGElement {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", ICONS[name]);
  svg.append(path);
  return svg;
}

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

export function createToolbar(actions: Actions, view: EditorView): Island {
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
