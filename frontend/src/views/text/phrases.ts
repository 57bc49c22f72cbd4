/** CodeMirror's phrases and the labels for screen readers, in the user's language. */

import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";

import { t } from "../../i18n";
import type { Notation } from "../../protocol/messages";

/** CodeMirror's phrases by the codes of their translations. */
const PHRASES: Record<string, string> = {
  "page-text-find": "Find",
  "page-text-replace": "Replace",
  "page-text-next": "next",
  "page-text-previous": "previous",
  "page-text-all": "all",
  "page-text-match-case": "match case",
  "page-text-regexp": "regexp",
  "page-text-by-word": "by word",
  "page-text-replace-one": "replace",
  "page-text-replace-all": "replace all",
  "page-text-close": "close",
  "page-text-current-match": "current match",
  "page-text-replaced-match": "replaced match on line $",
  "page-text-replaced-matches": "replaced $ matches",
  "page-text-on-line": "on line",
  "page-text-go-to-line": "Go to line",
  "page-text-go": "go",
  "page-text-diagnostics": "Diagnostics",
  "page-text-no-diagnostics": "No diagnostics",
  "page-text-completions": "Completions",
  "page-text-folded-lines": "Folded lines",
  "page-text-unfolded-lines": "Unfolded lines",
  "page-text-folded-code": "folded code",
  "page-text-unfold": "unfold",
  "page-text-fold-line": "Fold line",
  "page-text-unfold-line": "Unfold line",
  "page-text-selection-deleted": "Selection deleted",
  "page-text-to": "to",
};

/** The title of a text. */
export function title(notation: Notation): string {
  return t(notation === "python" ? "page-text-python" : "page-text-blocktext");
}

/** The current phrases and labels of a program editor. */
export function words(notation: Notation): Extension {
  return labelled(title(notation));
}

/** The phrases and labels of an editor with this name. */
export function labelled(label: string): Extension {
  const phrases = Object.fromEntries(Object.entries(PHRASES).map(([key, phrase]) => [phrase, t(key)]));
  return [
    EditorState.phrases.of(phrases),
    EditorView.contentAttributes.of({
      "aria-label": label,
      "aria-description": t("page-text-leaving"),
      // Accessibility checkers only recognise a focusable element by this.
      tabindex: "0",
      spellcheck: "false",
      translate: "no",
    }),
  ];
}
