/** The text and the program: what the user types goes there, what others edit comes from there. */

import { Annotation, Transaction, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";

import type { Notation } from "../messages";
import type { Program } from "../program";
import { changesBetween } from "./changes";

/** Marks a change that comes from the program and needs no telling. */
const fromProgram = Annotation.define<boolean>();

/** Tells the program of the user's edits. */
export function tellEdits(program: Program, notation: Notation): Extension {
  return EditorView.updateListener.of(({ docChanged, transactions, view }) => {
    if (!docChanged || transactions.every((each) => each.annotation(fromProgram))) return;
    program.editedText(notation, () => view.state.doc.toString());
  });
}

/** Shows a text by the smallest change, with cursor, selection and scroll where they were. */
export function showText(view: EditorView, text: string): void {
  const before = view.state.doc.toString();
  const after = text.replace(/\r\n?/g, "\n");
  if (before === after) return;
  view.dispatch({
    changes: changesBetween(before, after),
    annotations: [fromProgram.of(true), Transaction.addToHistory.of(false)],
  });
}
