/** Marks the line that is running, or at which the program is paused, and the one that a teacher's note is about. */

import { type EditorState, type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView } from "@codemirror/view";

import type { Lines } from "./outline";

interface Shown {
  readonly lines: Lines;
  readonly look: string;
}

/** Lines that are marked for one reason. */
class MarkedLines {
  private readonly set = StateEffect.define<Shown | null>();
  readonly extension: Extension = StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update: (marks, transaction) => {
      const effect = transaction.effects.findLast((each) => each.is(this.set));
      return effect ? decorate(transaction.state, effect.value as Shown | null) : marks.map(transaction.changes);
    },
    provide: (own) => EditorView.decorations.from(own),
  });

  /** Mark lines in this look, or none. */
  show(view: EditorView, lines: Lines | null, look: string): void {
    view.dispatch({ effects: this.set.of(lines && { lines, look }) });
  }
}

const running = new MarkedLines();
const noted = new MarkedLines();

export function markedLines(): Extension {
  return [running.extension, noted.extension];
}

export function showRunning(view: EditorView, lines: Lines | null, isHeld: boolean): void {
  running.show(view, lines, isHeld ? "cm-running cm-held" : "cm-running");
}

export function showNoted(view: EditorView, lines: Lines | null): void {
  noted.show(view, lines, "cm-noted");
}

function decorate(state: EditorState, shown: Shown | null): DecorationSet {
  if (!shown) return Decoration.none;
  const mark = Decoration.line({ class: shown.look });
  const last = Math.min(shown.lines.last, state.doc.lines);
  const ranges = [];
  for (let line = shown.lines.first; line <= last; line += 1) ranges.push(mark.range(state.doc.line(line).from));
  return Decoration.set(ranges);
}
