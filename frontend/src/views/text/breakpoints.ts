/** Breakpoints in the gutter: a click or F9 sets and clears them. */

import { type EditorState, type Extension, RangeSet, StateEffect, StateField } from "@codemirror/state";
import { type EditorView, GutterMarker, gutter } from "@codemirror/view";

const setLines = StateEffect.define<readonly number[]>();

class Dot extends GutterMarker {
  override toDOM(): HTMLElement {
    const dot = document.createElement("span");
    dot.className = "breakpoint";
    return dot;
  }
}

const dot = new Dot();

function marks(state: EditorState, lines: readonly number[]): RangeSet<GutterMarker> {
  const known = lines.filter((line) => line <= state.doc.lines);
  const starts = known.map((line) => state.doc.line(line).from);
  return RangeSet.of(
    starts.map((from) => dot.range(from)),
    true,
  );
}

const field = StateField.define<RangeSet<GutterMarker>>({
  create: () => RangeSet.empty,
  update(value, transaction) {
    const effect = transaction.effects.findLast((each) => each.is(setLines));
    if (effect) return marks(transaction.state, effect.value as readonly number[]);
    return value.map(transaction.changes);
  },
});

/** `toggle` receives the number of the clicked line. */
export function breakpointGutter(toggle: (view: EditorView, line: number) => void): Extension {
  const beside = gutter({
    class: "cm-breakpoints",
    markers: (view) => view.state.field(field),
    initialSpacer: () => dot,
    // Under the pointer, a line without a breakpoint shows where one would go.
    renderEmptyElements: true,
    domEventHandlers: {
      mousedown: (view, line) => {
        toggle(view, view.state.doc.lineAt(line.from).number);
        return true;
      },
    },
  });
  return [field, beside];
}

/** Show breakpoints at these lines. */
export function showBreakpoints(view: EditorView, lines: readonly number[]): void {
  view.dispatch({ effects: setLines.of(lines) });
}
