/** The panel for renaming a variable, a function or a `when`. */

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { type EditorView, type Panel, showPanel } from "@codemirror/view";

import { t } from "../../i18n";

interface Renaming {
  readonly name: string;
  rename(to: string): void;
}

const setRenaming = StateEffect.define<Renaming | null>();

function button(label: string, type: "submit" | "button"): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = type;
  made.className = "cm-button";
  made.textContent = label;
  return made;
}

function labelled(name: string): { label: HTMLLabelElement; input: HTMLInputElement } {
  const label = document.createElement("label");
  const input = document.createElement("input");
  input.className = "cm-textfield";
  input.value = name;
  input.required = true;
  input.spellcheck = false;
  input.autocapitalize = "off";
  label.append(t("page-text-rename-to", { name }), " ", input);
  return { label, input };
}

function close(view: EditorView): void {
  view.dispatch({ effects: setRenaming.of(null) });
  view.focus();
}

function finish(view: EditorView, renaming: Renaming, typed: string): void {
  const name = typed.trim();
  if (name && name !== renaming.name) renaming.rename(name);
  close(view);
}

function panel(view: EditorView, renaming: Renaming): Panel {
  const form = document.createElement("form");
  form.className = "text-rename";
  const { label, input } = labelled(renaming.name);
  const cancel = button(t("page-text-cancel"), "button");
  form.append(label, button(t("page-text-rename"), "submit"), cancel);
  cancel.onclick = () => close(view);
  form.onkeydown = (event) => {
    if (event.key === "Escape") close(view);
  };
  form.onsubmit = (event) => {
    event.preventDefault();
    finish(view, renaming, input.value);
  };
  return { dom: form, top: true, mount: () => input.select() };
}

const field = StateField.define<Renaming | null>({
  create: () => null,
  update(value, transaction) {
    const effect = transaction.effects.findLast((each) => each.is(setRenaming));
    return effect ? (effect.value as Renaming | null) : value;
  },
  provide: (own) => showPanel.from(own, (renaming) => (renaming ? (view) => panel(view, renaming) : null)),
});

export function renamePanel(): Extension {
  return field;
}

/** Ask for a new name and call `rename` with it. */
export function askForName(view: EditorView, name: string, rename: (to: string) => void): void {
  view.dispatch({ effects: setRenaming.of({ name, rename }) });
}
