/** The actions in a text besides typing. */

import { openSearchPanel } from "@codemirror/search";
import { EditorView, type KeyBinding } from "@codemirror/view";
import type { ReadonlySignal } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import { helpAtCursor } from "./help";
import type { Outline } from "./outline";
import { cursorLine, positionOf, selectAt } from "./places";
import { askForName } from "./rename";
import type { Requests } from "./requests";

export type ActionName =
  | "undo"
  | "redo"
  | "find"
  | "format"
  | "breakpoint"
  | "help"
  | "definition"
  | "rename"
  | "reveal"
  | "why";

/** An action and its keys in CodeMirror's notation. */
export interface Action {
  readonly name: ActionName;
  readonly keys: readonly string[];
  run(view: EditorView): void;
}

/** The actions of one text. */
export class TextActions {
  readonly all: readonly Action[];
  private restoring = false;

  constructor(
    private readonly context: Context,
    private readonly requests: Requests,
    private readonly outline: ReadonlySignal<Outline>,
  ) {
    const { program, connection } = context;
    this.all = [
      { name: "undo", keys: ["Mod-z"], run: () => this.restore(program.state.value.canUndo, () => program.undo()) },
      {
        name: "redo",
        keys: ["Mod-y", "Mod-Shift-z"],
        run: () => this.restore(program.state.value.canRedo, () => program.redo()),
      },
      { name: "find", keys: ["Mod-f"], run: openSearchPanel },
      {
        name: "format",
        keys: ["Shift-Alt-f"],
        run: () => {
          program.flush();
          connection.send({ kind: "Format" });
        },
      },
      { name: "breakpoint", keys: ["F9"], run: (view) => this.toggleBreakpoint(view, cursorLine(view.state)) },
      { name: "help", keys: ["Mod-i"], run: (view) => void helpAtCursor(view, requests) },
      {
        name: "definition",
        keys: ["F12"],
        run: (view) => void this.goToDefinition(view, view.state.selection.main.head),
      },
      { name: "rename", keys: ["F2"], run: (view) => void this.rename(view) },
      { name: "reveal", keys: ["Alt-Enter"], run: (view) => this.revealElsewhere(view) },
      { name: "why", keys: ["Alt-y"], run: (view) => this.askWhy(view) },
    ];
  }

  get keys(): KeyBinding[] {
    return this.all.flatMap(({ keys, run: act }) => {
      const run = (view: EditorView) => {
        act(view);
        return true;
      };
      return keys.map((key) => ({ key, preventDefault: true, run }));
    });
  }

  /** Whether the next change comes from an undo or redo here; reading it resets it. */
  takeRestoring(): boolean {
    const { restoring } = this;
    this.restoring = false;
    return restoring;
  }

  /** Set or clear a breakpoint at the statement that begins on a line, also on one that has just been typed. */
  toggleBreakpoint(view: EditorView, line: number): void {
    this.context.program.whenSettled(() => this.toggleBreakpointNow(view, line));
  }

  private toggleBreakpointNow(view: EditorView, line: number): void {
    const block = this.outline.value.beginningAt(line);
    if (!block) return say(view, t("page-text-no-statement", { line }));
    const { running } = this.context;
    running.toggleBreakpoint(block);
    say(
      view,
      t(running.breakpoints.value.has(block) ? "page-text-breakpoint-set" : "page-text-breakpoint-cleared", { line }),
    );
  }

  async goToDefinition(view: EditorView, position: number): Promise<void> {
    const found = await this.requests.describe(view.state, position);
    if (!found?.line) return say(view, t("page-text-no-definition"));
    selectAt(view, positionOf(view.state, found.line, found.column ?? 0));
    view.focus();
  }

  private restore(possible: boolean, act: () => void): void {
    this.restoring = possible;
    act();
  }

  private async rename(view: EditorView): Promise<void> {
    const found = await this.requests.describe(view.state, view.state.selection.main.head);
    const sort = found?.sort;
    const name = found?.name;
    if (!sort || !name) return say(view, t("page-text-no-rename"));
    askForName(view, name, (to) => {
      this.context.program.flush();
      this.context.connection.send({ kind: "Rename", sort, name, new: to });
    });
  }

  private askWhy(view: EditorView): void {
    const { askingWhy } = this.context;
    const line = cursorLine(view.state);
    const block = this.outline.value.around(line);
    if (!block) return say(view, t("page-text-no-statement", { line }));
    if (!askingWhy.isPossible) return say(view, t("page-why-none"));
    askingWhy.aboutBlock(block);
  }

  private revealElsewhere(view: EditorView): void {
    const block = this.outline.value.around(cursorLine(view.state));
    if (block) this.context.reveal(block);
  }
}

function say(view: EditorView, text: string): void {
  view.dispatch({ effects: EditorView.announce.of(text) });
}
