/** Marks the line that is running, or at which the program is paused. */

import { type EditorState, type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView } from "@codemirror/view";

import type { Lines } from "./outline";

interface Shown {
  readonly lines: Lines;
  readonly held: boolean;
}

const setRunning = StateEffect.define<Shown | null>();

const runs = Decoration.line({ class: "cm-running" });
const held = Decoration.line({ class: "cm-running cm-held" });

function decorate(state: EditorState, shown: Shown | null): DecorationSet {
  if (!shown) return Decoration.none;
  const last = Math.min(shown.lines.last, state.doc.lines);
  const ranges = [];
  for (let line = shown.lines.first; line <= last; line += 1) {
    ranges.push((shown.held ? held : runs).range(state.doc.line(line).from));
  }
  return Decoration.set(ranges);
}

const field = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    const effect = transaction.effects.findLast((each) => each.is(setRunning));
    return effect ? decorate(transaction.state, effect.value as Shown | null) : marks.map(transaction.changes);
  },
  provide: (own) => EditorView.decorations.from(own),
});

export function runningLine(): Extension {
  return field;
}

export function showRunning(view: EditorView, lines: Lines | null, isHeld: boolean): void {
  view.dispatch({ effects: setRunning.of(lines && { lines, held: isHeld }) });
}
