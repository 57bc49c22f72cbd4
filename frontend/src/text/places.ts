/** Places in a text: by line and column as the server counts them, from 1. */

import { EditorSelection, type EditorState } from "@codemirror/state";
import { EditorView } from "@codemirror/view";

/** Kept free above and below a line that is shown, in pixels. */
const MARGIN = 48;

/** The position of a line and column, or the nearest there is; column 0 is the line's first word. */
export function positionOf(state: EditorState, line: number, column: number): number {
  const { from, to, text } = state.doc.line(Math.min(Math.max(line, 1), state.doc.lines));
  if (column > 0) return Math.min(from + column - 1, to);
  return from + Math.max(0, text.search(/\S/));
}

/**
 * Scroll a position into view; the page round the text stays where it is, as CodeMirror's own way
 * would not let it.
 */
export function scrollTo(view: EditorView, position: number): void {
  const { scrollDOM } = view;
  const { top, bottom } = view.lineBlockAt(position);
  const visibleTop = scrollDOM.scrollTop;
  const height = scrollDOM.clientHeight;
  if (top >= visibleTop && bottom <= visibleTop + height) return;
  const above = top < visibleTop;
  scrollDOM.scrollTop = above ? top - MARGIN : bottom - height + MARGIN;
}

/** Put the cursor somewhere, with the place in view. */
export function selectAt(view: EditorView, position: number): void {
  view.dispatch({ selection: EditorSelection.cursor(position) });
  scrollTo(view, position);
}

/** The number of the line the cursor is in. */
export function cursorLine(state: EditorState): number {
  return state.doc.lineAt(state.selection.main.head).number;
}
