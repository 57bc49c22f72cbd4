/** A code editor that reports edits and marks problems at their lines. */

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { foldKeymap } from "@codemirror/language";
import { searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState, type Extension } from "@codemirror/state";
import { EditorView, keymap, tooltips } from "@codemirror/view";
import { effect } from "@preact/signals";

import "../../views/text/text.css";
import type { CustomBlockProblem } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import { changesBetween } from "../../views/text/changes";
import { appearance, editing } from "../../views/text/editor";
import { labelled } from "../../views/text/phrases";
import { positionOf, selectAt } from "../../views/text/places";
import { problemMarks, showProblems } from "../../views/text/problems";

/** Marks a change that the user did not type. */
const fromOutside = Annotation.define<boolean>();

export class Code implements Island {
  readonly dom = document.createElement("div");
  private readonly view: EditorView;
  private readonly words = new Compartment();
  private readonly end: () => void;

  /**
   * @param label returns its accessible name in the page's language.
   * @param typed called with the whole text after each edit.
   * @param extensions of its language.
   */
  constructor(label: () => string, typed: (text: string) => void, extensions: Extension) {
    // Tooltips go outside the editor, which would clip them.
    const boxes = document.createElement("div");
    boxes.className = "text-boxes";
    this.dom.className = "text-view code";
    const own = [
      this.words.of([]),
      tooltips({ parent: boxes }),
      problemMarks(),
      appearance(),
      editing(),
      history(),
      extensions,
    ];
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

  /** Show a text with the smallest possible change. */
  show(text: string): void {
    const before = this.view.state.doc.toString();
    if (before === text) return;
    this.view.dispatch({ changes: changesBetween(before, text), annotations: fromOutside.of(true) });
  }

  showProblems(problems: readonly CustomBlockProblem[]): void {
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
