/** The text and the program: what the user types goes there, what others edit comes from there. */

import { Annotation, Transaction, type ChangeSet, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";

import type { Notation } from "../messages";
import type { Program } from "../program";
import { changesBetween } from "./changes";
import { selectAt } from "./places";

/** Marks a change that comes from the program and needs no telling. */
const fromProgram = Annotation.define<boolean>();

/** Tells the program of the user's edits. */
export function tellEdits(program: Program, notation: Notation): Extension {
  return EditorView.updateListener.of(({ docChanged, transactions, view }) => {
    if (!docChanged || transactions.every((each) => each.annotation(fromProgram))) return;
    program.editedText(notation, () => view.state.doc.toString());
  });
}

/**
 * Shows a text by the smallest change, with cursor, selection and scroll where they were; the cursor
 * goes to the change when one `follows` it, as after an undo.
 */
export function showText(view: EditorView, text: string, follows: boolean): void {
  const before = view.state.doc.toString();
  const after = text.replace(/\r\n?/g, "\n");
  if (before === after) return;
  const changes = view.state.changes(changesBetween(before, after));
  view.dispatch({
    changes,
    annotations: [fromProgram.of(true), Transaction.addToHistory.of(false)],
  });
  if (follows) selectAt(view, firstChanged(changes));
}

/** Behind the first piece that has changed, in the new text. */
function firstChanged(changes: ChangeSet): number {
  let end = 0;
  changes.iterChangedRanges((_fromA, _toA, _fromB, toB) => (end ||= toB));
  return end;
}
