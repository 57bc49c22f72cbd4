/** The Enter key in Block-Text: after a `:` it opens a block, and adds a missing `end`. */

import { getIndentation, getIndentUnit, indentString } from "@codemirror/language";
import { EditorSelection, type StateCommand } from "@codemirror/state";

import { lacksEnd, opensBlock } from "./folding";

const GOES_ON = /^\s*(?:else|elif)\b/;

/** Adds an inner line and an `end` below; returns false for a plain new line. */
export const openBlock: StateCommand = ({ state, dispatch }) => {
  const { main } = state.selection;
  const line = state.doc.lineAt(main.head);
  const opens = main.empty && main.head === line.to && opensBlock(line.text);
  if (!opens || GOES_ON.test(line.text) || !lacksEnd(state)) return false;
  const outer = getIndentation(state, line.from) ?? /^\s*/.exec(line.text)?.[0].length ?? 0;
  const inner = `\n${indentString(state, outer + getIndentUnit(state))}`;
  dispatch(
    state.update({
      changes: { from: main.head, insert: `${inner}\n${indentString(state, outer)}end` },
      selection: EditorSelection.cursor(main.head + inner.length),
      scrollIntoView: true,
      userEvent: "input",
    }),
  );
  return true;
};
