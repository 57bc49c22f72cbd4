/** A text view: the program as Block-Text or as Python. */

import "./text.css";

import { Compartment, EditorState } from "@codemirror/state";
import { EditorView, tooltips } from "@codemirror/view";
import { computed, effect, type ReadonlySignal } from "@preact/signals";

import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { ProgramState } from "../../model/program";
import { valuesInWords } from "../../model/values-there";
import type { Notation } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { TextActions } from "./actions";
import { showBreakpoints } from "./breakpoints";
import { extensions } from "./editor";
import { showNoted, showRunning } from "./marked-lines";
import { Outline } from "./outline";
import { words } from "./phrases";
import { cursorLine, positionOf, scrollTo, selectAt } from "./places";
import { showProblems } from "./problems";
import { Requests } from "./requests";
import { sendEdits, showText } from "./sync";
import { createToolbar } from "./toolbar";
import { showValues } from "./values";

export interface TextIsland extends Island {
  focus(): void;
  /** Show a statement: the block's id. */
  reveal(block: string): void;
  describeStep(block: string): string;
  /** Go to a line and column, from 1; column 0 is the line's first word. */
  goTo(line: number, column: number): void;
}

class TextView implements TextIsland {
  readonly dom = document.createElement("section");
  /** Tooltips go outside the view, which would clip them. */
  private readonly boxes = document.createElement("div");
  private readonly requests: Requests;
  private readonly outline: ReadonlySignal<Outline>;
  private readonly actions: TextActions;
  private readonly view: EditorView;
  private readonly toolbar: Island;
  private readonly words = new Compartment();
  private readonly access = new Compartment();
  private readonly cleanup: Cleanup;
  private shown: ProgramState | null = null;
  private hasProblems = false;
  private hasBreakpoints = false;
  private runs = false;
  private hasValues = false;
  private hasNoted = false;

  constructor(
    private readonly context: Context,
    private readonly notation: Notation,
  ) {
    const { program } = context;
    this.outline = computed(() => new Outline(program.state.value.places, notation));
    this.requests = new Requests(context, notation);
    this.actions = new TextActions(context, this.requests, this.outline);
    this.boxes.className = "text-boxes";
    this.boxes.role = "region";
    document.body.append(this.boxes);
    this.view = new EditorView({ state: this.firstState() });
    this.toolbar = createToolbar(this.actions, this.view);
    this.dom.className = "text-view";
    this.dom.append(this.toolbar.dom, this.view.dom);
    this.cleanup = new Cleanup(
      effect(() => this.showProgram()),
      effect(() => this.showProblems()),
      effect(() => this.showBreakpoints()),
      effect(() => this.showRunning()),
      effect(() => this.showValues()),
      effect(() => this.showNoted()),
      effect(() => {
        this.boxes.ariaLabel = t("page-text-boxes", { view: t(`page-text-${notation}`) });
      }),
      effect(() => this.view.dispatch({ effects: this.words.reconfigure(words(notation)) })),
      effect(() => this.showAccess()),
    );
  }

  focus(): void {
    this.view.focus();
  }

  reveal(block: string): void {
    const lines = this.outline.value.head(block);
    if (lines) this.goTo(lines.first, 0);
  }

  describeStep(block: string): string {
    const lines = this.outline.value.head(block);
    const { doc } = this.view.state;
    return lines && lines.first <= doc.lines ? doc.line(lines.first).text.trim() : "";
  }

  goTo(line: number, column: number): void {
    selectAt(this.view, positionOf(this.view.state, line, column));
  }

  destroy(): void {
    this.cleanup.dispose();
    this.toolbar.destroy();
    this.requests.destroy();
    this.view.destroy();
    this.boxes.remove();
  }

  private firstState(): EditorState {
    return EditorState.create({
      extensions: [
        this.words.of([]),
        this.access.of([]),
        extensions(this.notation, this.actions, this.requests),
        tooltips({ parent: this.boxes }),
        sendEdits(this.context.program, this.notation),
        EditorView.clipboardInputFilter.of((text) => this.context.program.copied.pasted(text, this.notation)),
        EditorView.updateListener.of(({ selectionSet, view }) => {
          if (selectionSet && view.hasFocus) this.context.select(this.outline.peek().around(cursorLine(view.state)));
        }),
      ],
    });
  }

  /** Start all effects here: line numbers mean nothing before their text is shown. */
  private showProgram(): void {
    const state = this.context.program.state.value;
    if (state === this.shown) return;
    this.shown = state;
    showText(this.view, state[this.notation], this.actions.takeRestoring());
    this.dom.classList.toggle("stale", state.stale.includes(this.notation));
  }

  private showAccess(): void {
    const readOnly = this.context.program.readOnly.value !== null;
    this.view.dispatch({ effects: this.access.reconfigure(EditorState.readOnly.of(readOnly)) });
  }

  private showProblems(): void {
    this.showProgram();
    const all = [...this.context.program.state.value.problems, ...this.context.runError.value];
    const problems = all.filter(({ view }) => view === this.notation);
    if (problems.length > 0 || this.hasProblems) showProblems(this.view, problems);
    this.hasProblems = problems.length > 0;
  }

  private showBreakpoints(): void {
    this.showProgram();
    const outline = this.outline.value;
    const heads = [...this.context.running.breakpoints.value].map((block) => outline.head(block));
    const lines = heads.flatMap((head) => (head ? [head.first] : []));
    if (lines.length > 0 || this.hasBreakpoints) showBreakpoints(this.view, lines);
    this.hasBreakpoints = lines.length > 0;
  }

  private showValues(): void {
    this.showProgram();
    const outline = this.outline.value;
    const byLine = new Map<number, string>();
    for (const [block, text] of valuesInWords(this.context.running.values.value)) {
      const lines = outline.head(block);
      if (lines) byLine.set(lines.first, text);
    }
    if (byLine.size > 0 || this.hasValues) showValues(this.view, byLine);
    this.hasValues = byLine.size > 0;
  }

  private showNoted(): void {
    this.showProgram();
    const block = this.context.noted.value;
    const lines = block ? this.outline.value.head(block) : null;
    if (lines || this.hasNoted) showNoted(this.view, lines);
    this.hasNoted = lines !== null;
  }

  private showRunning(): void {
    this.showProgram();
    const { running } = this.context;
    const block = running.block.value;
    const lines = block ? this.outline.value.head(block) : null;
    const held = running.state.value.state === "held";
    if (lines || this.runs) showRunning(this.view, lines, held);
    this.runs = lines !== null;
    // Do not scroll away from where the user is typing while the program runs.
    if (lines && (held || !this.view.hasFocus)) scrollTo(this.view, positionOf(this.view.state, lines.first, 0));
  }
}

/** A view of the program in one notation. */
export function createText(context: Context, notation: Notation): TextIsland {
  return new TextView(context, notation);
}
