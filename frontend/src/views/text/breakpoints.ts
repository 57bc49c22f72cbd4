/** Breakpoints in the gutter: a click on a line number or beside it, or F9, sets and clears them. */

import { type EditorState, type Extension, RangeSet, StateEffect, StateField } from "@codemirror/state";
import { type BlockInfo, type EditorView, GutterMarker, gutter, lineNumbers } from "@codemirror/view";

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

type Toggle = (view: EditorView, line: number) => void;

function clicked(toggle: Toggle) {
  return {
    mousedown: (view: EditorView, line: BlockInfo) => {
      toggle(view, view.state.doc.lineAt(line.from).number);
      return true;
    },
  };
}

/** `toggle` receives the number of the clicked line. */
export function breakpointGutter(toggle: Toggle): Extension {
  const beside = gutter({
    class: "cm-breakpoints",
    markers: (view) => view.state.field(field),
    initialSpacer: () => dot,
    // Under the pointer, a line without a breakpoint shows where one would go.
    renderEmptyElements: true,
    domEventHandlers: clicked(toggle),
  });
  return [field, beside, lineNumbers({ domEventHandlers: clicked(toggle) })];
}

/** Show breakpoints at these lines. */
export function showBreakpoints(view: EditorView, lines: readonly number[]): void {
  view.dispatch({ effects: setLines.of(lines) });
}
