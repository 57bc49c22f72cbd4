/** The program that the three views show: edits go to the server, the results come back. */

import { signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { Document, Notation, Place, Problem, View, Workspace } from "../protocol/messages";

/** The program as the page knows it. */
export interface ProgramState {
  readonly blocktext: string;
  readonly python: string;
  readonly workspace: Workspace;
  readonly places: readonly Place[];
  readonly problems: readonly Problem[];
  /** Views that still show the last valid program because another view has errors. */
  readonly stale: readonly View[];
  readonly origin: View;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
}

const EMPTY: ProgramState = {
  blocktext: "",
  python: "",
  workspace: { stacks: [], variables: [] },
  places: [],
  problems: [],
  stale: [],
  origin: "blocktext",
  canUndo: false,
  canRedo: false,
};

/** A view's content after the last edit. */
interface Edit {
  readonly view: View;
  readonly content: string | Workspace;
}

function field(view: View): Notation | "workspace" {
  return view === "blocks" ? "workspace" : view;
}

/**
 * The program shared by the three views.
 *
 * A view calls `edited...` after each edit of the user and shows `state` whenever that
 * changes, updating only what differs. While edits are on
 * their way to the server, answers to earlier edits are not shown.
 */
export class Program {
  readonly state = signal<ProgramState>(EMPTY);
  /** The last edit until the server has saved it; it is sent again after a lost connection. */
  readonly unsaved = signal<Edit | null>(null);
  private project = "";
  private latest = EMPTY;
  private edits = 0;
  private answered = 0;
  /** The number of the last edit of each view. */
  private edited = new Map<View, number>();
  private pending = new Map<View, () => void>();
  private frame = 0;

  constructor(private readonly connection: Connection) {
    connection.on("Opened", (opened) => this.opened(opened.name));
    connection.on("Document", (document) => this.receive(document));
    connection.on("Saved", (saved) => {
      if (saved.edit >= this.edits) this.unsaved.value = null;
    });
  }

  /** Whether the server has answered every edit. */
  get settled(): boolean {
    return this.pending.size === 0 && this.answered >= this.edits;
  }

  /** Report an edit of the workspace; `read` is called at most once per frame. */
  editedBlocks(read: () => Workspace): void {
    this.schedule("blocks", () => this.send({ view: "blocks", content: read() }));
  }

  /** Report an edit of a text; `read` is called at most once per frame. */
  editedText(notation: Notation, read: () => string): void {
    this.schedule(notation, () => this.send({ view: notation, content: read() }));
  }

  /** Send pending edits now, before a message that depends on them. */
  flush(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const sending = [...this.pending.values()];
    this.pending.clear();
    for (const send of sending) send();
  }

  undo(): void {
    this.flush();
    this.connection.send({ kind: "Undo" });
  }

  redo(): void {
    this.flush();
    this.connection.send({ kind: "Redo" });
  }

  private schedule(view: View, send: () => void): void {
    this.pending.set(view, send);
    if (!this.frame) this.frame = requestAnimationFrame(() => this.flush());
  }

  private send(edit: Edit): void {
    this.unsaved.value = edit;
    const { view, content } = edit;
    this.latest = { ...this.latest, [field(view)]: content };
    this.edits += 1;
    this.edited.set(view, this.edits);
    if (typeof content !== "string") {
      this.connection.send({ kind: "EditBlocks", edit: this.edits, workspace: content });
    } else if (view !== "blocks") {
      this.connection.send({ kind: "EditText", edit: this.edits, notation: view, text: content });
    }
  }

  private receive(document: Document): void {
    this.answered = Math.max(this.answered, document.edit);
    this.latest = {
      ...this.contents(document),
      places: document.places ?? [],
      problems: document.problems ?? [],
      stale: document.stale ?? [],
      origin: document.origin,
      canUndo: document.can_undo ?? false,
      canRedo: document.can_redo ?? false,
    };
    if (!this.settled) return;
    if (this.superseded()) this.unsaved.value = null;
    this.state.value = this.latest;
  }

  /** The views' contents; an answer to an earlier edit does not overwrite a later one. */
  private contents(document: Document): Pick<ProgramState, Notation | "workspace"> {
    const older = (view: View) => (this.edited.get(view) ?? 0) > document.edit;
    const { blocktext, python, workspace } = this.latest;
    return {
      blocktext: older("blocktext") ? blocktext : (document.blocktext ?? blocktext),
      python: older("python") ? python : (document.python ?? python),
      workspace: older("blocks") ? workspace : (document.workspace ?? workspace),
    };
  }

  /** Whether the last edit has been changed since, for example by an undo, and must not be sent again. */
  private superseded(): boolean {
    const edit = this.unsaved.value;
    return edit !== null && this.latest[field(edit.view)] !== edit.content;
  }

  /** Handle an opened project: another one, or the same one after a reconnection. */
  private opened(name: string): void {
    const unsaved = name === this.project ? this.unsaved.value : null;
    if (name !== this.project) this.pending.clear();
    this.project = name;
    this.edits = this.answered = 0;
    this.edited.clear();
    this.latest = EMPTY;
    this.unsaved.value = null;
    if (unsaved) this.send(unsaved);
  }
}
