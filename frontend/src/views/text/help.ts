/** Help on the word under the pointer or at the cursor. */

import { type EditorState, type Extension, StateEffect, StateField } from "@codemirror/state";
import { EditorView, hoverTooltip, keymap, showTooltip, type Tooltip } from "@codemirror/view";

import { say, t } from "../../i18n";
import { deviceWord } from "../../model/robots";
import type { Description } from "../../protocol/messages";
import type { Requests } from "./requests";

const setHelp = StateEffect.define<Tooltip | null>();

const field = StateField.define<Tooltip | null>({
  create: () => null,
  update(value, transaction) {
    const effect = transaction.effects.findLast((each) => each.is(setHelp));
    if (effect) return effect.value as Tooltip | null;
    return transaction.docChanged || transaction.selection ? null : value;
  },
  provide: (own) => showTooltip.from(own),
});

function lacking(found: Description): string {
  return found.needs?.length ? t("page-text-lacks", { devices: found.needs.map(deviceWord).join(", ") }) : "";
}

/** What serves the senses of a skill on the chosen robot. */
function serving({ serves }: Description): string {
  return serves ? say(serves) : "";
}

function line(className: string, text: string): HTMLElement {
  const element = document.createElement("div");
  element.className = className;
  element.textContent = text;
  return element;
}

function dom(found: Description): HTMLElement {
  const box = document.createElement("div");
  box.className = "text-help";
  box.append(line("text-help-title", found.title ?? ""));
  if (found.text) box.append(line("text-help-text", found.text));
  if (serving(found)) box.append(line("text-help-serves", serving(found)));
  if (lacking(found)) box.append(line("text-help-lacks", lacking(found)));
  return box;
}

function tooltip(state: EditorState, position: number, found: Description): Tooltip {
  const start = state.doc.lineAt(position).from;
  const from = found.from_column ? start + found.from_column - 1 : position;
  const to = found.to_column ? start + found.to_column - 1 : position;
  const length = state.doc.length;
  return {
    pos: Math.min(from, length),
    end: Math.min(Math.max(from, to), length),
    above: true,
    create: () => ({ dom: dom(found) }),
  };
}

async function explain(state: EditorState, position: number, requests: Requests): Promise<Tooltip | null> {
  const found = await requests.describe(state, position);
  return found?.title ? tooltip(state, position, found) : null;
}

/** Show help on the word at the cursor and announce it. */
export async function helpAtCursor(view: EditorView, requests: Requests): Promise<void> {
  const { state } = view;
  const position = state.selection.main.head;
  const found = await requests.describe(state, position);
  if (view.state.doc !== state.doc) return;
  const known = found?.title ? found : null;
  const text = known
    ? [known.title, known.text, serving(known), lacking(known)].filter(Boolean).join(". ")
    : t("page-text-no-help");
  view.dispatch({
    effects: [setHelp.of(known && tooltip(state, position, known)), EditorView.announce.of(text)],
  });
}

function close(view: EditorView): boolean {
  if (!view.state.field(field)) return false;
  view.dispatch({ effects: setHelp.of(null) });
  return true;
}

/** Help under the pointer, and an element for help at the cursor; Escape closes it. */
export function help(requests: Requests): Extension {
  return [
    field,
    hoverTooltip((view, position) => explain(view.state, position, requests)),
    keymap.of([{ key: "Escape", run: close }]),
  ];
}
