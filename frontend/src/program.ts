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

/**
 * The three views' common ground.
 *
 * A view calls `edited` whenever its user has changed something, and shows `state` whenever that
 * changes, touching only what differs from what it shows already. While the user's own edits are on
 * their way, answers to earlier ones are not shown: a newer one is coming.
 */
export class Program {
  readonly state = signal<ProgramState>(EMPTY);
  private latest = EMPTY;
  private edits = 0;
  private answered = 0;
  private pending = new Map<View, () => void>();
  private frame = 0;

  constructor(private readonly connection: Connection) {
    connection.on("Opened", () => this.reset());
    connection.on("Document", (document) => this.receive(document));
  }

  /** Whether the server has seen, and answered, everything that was edited. */
  get settled(): boolean {
    return this.pending.size === 0 && this.answered >= this.edits;
  }

  /** The workspace has been edited; `read` is called once a frame at most. */
  editedBlocks(read: () => Workspace): void {
    this.schedule("blocks", () => {
      const workspace = read();
      this.latest = { ...this.latest, workspace };
      this.connection.send({ kind: "EditBlocks", edit: ++this.edits, workspace });
    });
  }

  /** A text has been edited; `read` is called once a frame at most. */
  editedText(notation: Notation, read: () => string): void {
    this.schedule(notation, () => {
      const text = read();
      this.latest = { ...this.latest, [notation]: text };
      this.connection.send({ kind: "EditText", edit: ++this.edits, notation, text });
    });
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

  private receive(document: Document): void {
    this.answered = Math.max(this.answered, document.edit);
    this.latest = {
      blocktext: document.blocktext ?? this.latest.blocktext,
      python: document.python ?? this.latest.python,
      workspace: document.workspace ?? this.latest.workspace,
      places: document.places ?? [],
      problems: document.problems ?? [],
      stale: document.stale ?? [],
      origin: document.origin,
      canUndo: document.can_undo ?? false,
      canRedo: document.can_redo ?? false,
    };
    if (this.settled) this.state.value = this.latest;
  }

  private reset(): void {
    this.pending.clear();
    this.edits = this.answered = 0;
    this.latest = EMPTY;
  }
}
