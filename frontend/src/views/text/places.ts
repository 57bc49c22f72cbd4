/** Positions in a text by line and column, from 1 as in messages. */

import { EditorSelection, type EditorState } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";

/** The margin above and below a line that is scrolled into view, in pixels. */
const MARGIN = 48;

/** The position of a line and column, or the nearest one; column 0 is the line's first word. */
export function positionOf(state: EditorState, line: number, column: number): number {
  const { from, to, text } = state.doc.line(Math.min(Math.max(line, 1), state.doc.lines));
  if (column > 0) return Math.min(from + column - 1, to);
  return from + Math.max(0, text.search(/\S/));
}

/**
 * Scroll a position into view without scrolling the page, which CodeMirror's own method
 * would do.
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

/** Move the cursor to a position and scroll to it. */
export function selectAt(view: EditorView, position: number): void {
  view.dispatch({ selection: EditorSelection.cursor(position) });
  scrollTo(view, position);
}

/** The number of the cursor's line. */
export function cursorLine(state: EditorState): number {
  return state.doc.lineAt(state.selection.main.head).number;
}
