/** Values of variables behind the lines of a text, at the moment that is shown. */

import { type EditorState, type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, WidgetType } from "@codemirror/view";

/** The values by their line, from 1. */
export type ValuesByLine = ReadonlyMap<number, string>;

const setValues = StateEffect.define<ValuesByLine>();

class Values extends WidgetType {
  constructor(private readonly text: string) {
    super();
  }

  override eq({ text }: Values): boolean {
    return text === this.text;
  }

  override toDOM(): HTMLElement {
    const dom = document.createElement("span");
    dom.className = "cm-values";
    dom.textContent = this.text;
    return dom;
  }

  /** A click goes to the end of the line, as behind any other. */
  override ignoreEvent(): boolean {
    return false;
  }
}

function decorate(state: EditorState, values: ValuesByLine): DecorationSet {
  const ranges = [...values]
    .filter(([line]) => line <= state.doc.lines)
    .map(([line, text]) => Decoration.widget({ widget: new Values(text), side: 1 }).range(state.doc.line(line).to));
  return Decoration.set(ranges, true);
}

const field = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(shown, transaction) {
    const effect = transaction.effects.findLast((each) => each.is(setValues));
    return effect ? decorate(transaction.state, effect.value as ValuesByLine) : shown.map(transaction.changes);
  },
  provide: (own) => EditorView.decorations.from(own),
});

export function values(): Extension {
  return field;
}

export function showValues(view: EditorView, byLine: ValuesByLine): void {
  view.dispatch({ effects: setValues.of(byLine) });
}
