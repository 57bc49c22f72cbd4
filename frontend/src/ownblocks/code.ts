/** An editor for some code: what is typed is told, problems are marked at their lines. */

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { foldKeymap } from "@codemirror/language";
import { searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState, type Extension } from "@codemirror/state";
import { EditorView, keymap, tooltips } from "@codemirror/view";
import { effect } from "@preact/signals";

import "../text/text.css";
import type { Island } from "../island";
import type { OwnBlockProblem } from "../messages";
import { changesBetween } from "../text/changes";
import { appearance, editing } from "../text/editor";
import { labelled } from "../text/phrases";
import { positionOf, selectAt } from "../text/places";
import { problemMarks, showProblems } from "../text/problems";

/** Marks a change that nobody typed here. */
const fromOutside = Annotation.define<boolean>();

export class Code implements Island {
  readonly dom = document.createElement("div");
  private readonly view: EditorView;
  private readonly words = new Compartment();
  private readonly end: () => void;

  /**
   * @param label names it, in the language of the page.
   * @param typed is called with the whole text after each change that is made here.
   * @param extensions of its language.
   */
  constructor(label: () => string, typed: (text: string) => void, extensions: Extension) {
    // Help and suggestions: outside the text, which would cut them off.
    const boxes = document.createElement("div");
    boxes.className = "text-boxes";
    this.dom.className = "text-view code";
    const own = [this.words.of([]), tooltips({ parent: boxes }), problemMarks(), appearance(), editing(), history(), extensions];
    const keys = keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...foldKeymap, indentWithTab]);
    this.view = new EditorView({ state: EditorState.create({ extensions: [own, keys, tell(typed)] }) });
    this.dom.append(this.view.dom, boxes);
    this.end = effect(() => this.view.dispatch({ effects: this.words.reconfigure(labelled(label())) }));
  }

  destroy(): void {
    this.end();
    this.view.destroy();
    this.dom.remove();
  }

  /** Show a text by the smallest change. */
  show(text: string): void {
    const before = this.view.state.doc.toString();
    if (before === text) return;
    this.view.dispatch({ changes: changesBetween(before, text), annotations: fromOutside.of(true) });
  }

  showProblems(problems: readonly OwnBlockProblem[]): void {
    showProblems(this.view, problems);
  }

  /** Go to a line, from 1, and a column; column 0 is the line's first word. */
  goTo(line: number, column = 0): void {
    selectAt(this.view, positionOf(this.view.state, line, column));
    this.view.focus();
  }

  focus(): void {
    this.view.focus();
  }
}

function tell(typed: (text: string) => void): Extension {
  return EditorView.updateListener.of(({ docChanged, transactions, view }) => {
    const outside = transactions.every((each) => each.annotation(fromOutside));
    if (docChanged && !outside) typed(view.state.doc.toString());
  });
}
