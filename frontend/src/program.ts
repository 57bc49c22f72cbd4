/** The program that the three views show: what was edited goes to the server, what follows comes back. */

import { signal } from "@preact/signals";

import type { Connection } from "./connection";
import type { Document, Notation, Place, Problem, View, Workspace } from "./messages";

/** The program as the page knows it. */
export interface ProgramState {
  readonly blocktext: string;
  readonly python: string;
  readonly workspace: Workspace;
  readonly places: readonly Place[];
  readonly problems: readonly Problem[];
  /** Views that show the last good program, since another one has errors. */
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

/** A view's content as its user left it. */
interface Edit {
  readonly view: View;
  readonly content: string | Workspace;
}

function field(view: View): Notation | "workspace" {
  return view === "blocks" ? "workspace" : view;
}

/**
 * The three views' common ground.
 *
 * A view calls `edited` whenever its user has changed something, and shows `state` whenever that
 * changes, touching only what differs from what it shows already. While the user's own edits are on
 * their way, answers to earlier ones are not shown: a newer one is coming.
 */
export class Program {
  readonly state = signal<ProgramState>(EMPTY);
  /** The last edit, until it is on disk: said again when the connection was lost before that. */
  readonly unsaved = signal<Edit | null>(null);
  private project = "";
  private latest = EMPTY;
  private edits = 0;
  private answered = 0;
  /** Of each view the number of its last edit. */
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

  /** Whether the server has seen, and answered, everything that was edited. */
  get settled(): boolean {
    return this.pending.size === 0 && this.answered >= this.edits;
  }

  /** The workspace has been edited; `read` is called once a frame at most. */
  editedBlocks(read: () => Workspace): void {
    this.schedule("blocks", () => this.send({ view: "blocks", content: read() }));
  }

  /** A text has been edited; `read` is called once a frame at most. */
  editedText(notation: Notation, read: () => string): void {
    this.schedule(notation, () => this.send({ view: notation, content: read() }));
  }

  /** Send what is still to be sent, before a message that speaks of it. */
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

  /** The views' contents: an answer to an earlier edit does not undo a later one. */
  private contents(told: Document): Pick<ProgramState, Notation | "workspace"> {
    const older = (view: View) => (this.edited.get(view) ?? 0) > told.edit;
    const { blocktext, python, workspace } = this.latest;
    return {
      blocktext: older("blocktext") ? blocktext : (told.blocktext ?? blocktext),
      python: older("python") ? python : (told.python ?? python),
      workspace: older("blocks") ? workspace : (told.workspace ?? workspace),
    };
  }

  /** Whether what the user left has been changed since, as by undoing: it is not to be said again. */
  private superseded(): boolean {
    const edit = this.unsaved.value;
    return edit !== null && this.latest[field(edit.view)] !== edit.content;
  }

  /** A project is open: another one, or the same one after the connection was lost. */
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
