/** CodeMirror's own words, and what a screen reader says of a text, in the user's language. */

import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";

import { t } from "../i18n";
import type { Notation } from "../messages";

/** CodeMirror's phrases by our words for them. */
const PHRASES: Record<string, string> = {
  "text.find": "Find",
  "text.replace": "Replace",
  "text.next": "next",
  "text.previous": "previous",
  "text.all": "all",
  "text.matchCase": "match case",
  "text.regexp": "regexp",
  "text.byWord": "by word",
  "text.replaceOne": "replace",
  "text.replaceAll": "replace all",
  "text.close": "close",
  "text.currentMatch": "current match",
  "text.replacedMatch": "replaced match on line $",
  "text.replacedMatches": "replaced $ matches",
  "text.onLine": "on line",
  "text.goToLine": "Go to line",
  "text.go": "go",
  "text.diagnostics": "Diagnostics",
  "text.noDiagnostics": "No diagnostics",
  "text.completions": "Completions",
  "text.foldedLines": "Folded lines",
  "text.unfoldedLines": "Unfolded lines",
  "text.foldedCode": "folded code",
  "text.unfold": "unfold",
  "text.foldLine": "Fold line",
  "text.unfoldLine": "Unfold line",
  "text.selectionDeleted": "Selection deleted",
  "text.to": "to",
};

/** The title of a text. */
export function title(notation: Notation): string {
  return t(notation === "python" ? "text.python" : "text.blocktext");
}

/** All words of an editor of the program, as they are now. */
export function words(notation: Notation): Extension {
  return labelled(title(notation));
}

/** All words of an editor that is called so. */
export function labelled(label: string): Extension {
  const phrases = Object.fromEntries(Object.entries(PHRASES).map(([key, phrase]) => [phrase, t(key)]));
  return [
    EditorState.phrases.of(phrases),
    EditorView.contentAttributes.of({
      "aria-label": label,
      "aria-description": t("text.leaving"),
      // Checkers of accessibility know a place for the keyboard by this alone.
      tabindex: "0",
      spellcheck: "false",
      translate: "no",
    }),
  ];
}
