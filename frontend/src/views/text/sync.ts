/** Connects a text with the program, in both directions. */

import { Annotation, type ChangeSet, type Extension, Transaction } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import type { Program } from "../../model/program";
import type { Notation } from "../../protocol/messages";
import { changesBetween } from "./changes";
import { selectAt } from "./places";

/** Marks a change that comes from the program and is not reported to it. */
const fromProgram = Annotation.define<boolean>();

// Why: docs/decisions.md, "The page is thin"
/** Reports the user's edits to the program. */
export function sendEdits(program: Program, notation: Notation): Extension {
  return EditorView.updateListener.of(({ docChanged, transactions, view }) => {
    if (!docChanged || transactions.every((each) => each.annotation(fromProgram))) return;
    program.editedText(notation, () => view.state.doc.toString());
  });
}

/**
 * Updates the text with the smallest possible change, keeping the cursor, selection and scroll
 * position; the cursor moves to the change if `follows` is true, as after an undo.
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

/** The end of the first change, in the new text. */
function firstChanged(changes: ChangeSet): number {
  let end = 0;
  changes.iterChangedRanges((_fromA, _toA, _fromB, toB) => (end ||= toB));
  return end;
}
