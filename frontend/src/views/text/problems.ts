/** The program's problems, underlined in the text and marked beside it. */

import { type Diagnostic, lintGutter, lintKeymap, previousDiagnostic, setDiagnostics } from "@codemirror/lint";
import { type EditorState, type Extension, Prec } from "@codemirror/state";
import { type EditorView, keymap } from "@codemirror/view";
import { type Phrase, say } from "../../i18n";

import type { Problem } from "../../protocol/messages";
import { positionOf } from "./places";

/** A problem at a position in a text. */
type Finding = Pick<Problem, "severity" | "line" | "column" | "end_column"> & { readonly message: Phrase | string };

function endOf(state: EditorState, problem: Finding, from: number): number {
  const line = problem.line ?? 0;
  const end = problem.end_column ?? 0;
  if (end > 0) return Math.max(from, positionOf(state, line, end));
  const column = problem.column ?? 0;
  const word = column > 0 ? state.wordAt(from) : null;
  return word ? word.to : state.doc.lineAt(from).to;
}

function diagnostic(state: EditorState, problem: Finding): Diagnostic {
  const from = positionOf(state, problem.line ?? 0, problem.column ?? 0);
  const to = endOf(state, problem, from);
  return { from, to, severity: problem.severity, message: say(problem.message) };
}

/** Show the problems of one text. */
export function showProblems(view: EditorView, problems: readonly Finding[]): void {
  const { state } = view;
  const diagnostics = problems.map((problem) => diagnostic(state, problem));
  diagnostics.sort((a, b) => a.from - b.from);
  view.dispatch(setDiagnostics(state, diagnostics));
}

/** F8 goes to the next problem, Shift+F8 to the previous one. */
export function problemMarks(): Extension {
  const keys = [...lintKeymap, { key: "Shift-F8", run: previousDiagnostic }];
  return [lintGutter(), Prec.high(keymap.of(keys))];
}
