/** The program that the three views show: edits go to the server, the results come back. */

import { signal } from "@preact/signals";

import type { Phrase } from "../i18n";
import type { Connection } from "../protocol/connection";
import type { Document, Notation, Opened, Place, Problem, View, Welcome, Workspace } from "../protocol/messages";
import { CopiedStatement } from "./copied-statement";
import type { Drafts, Left } from "./drafts";
import { ShownProblems } from "./shown-problems";
import { type Content, type Repeated, repeated, Unsaved } from "./unsaved";

/**
 * How far the page and the server are from showing the same program.
 *
 * - `closed`: the server hasn't sent the program since it was opened, or since the connection was lost. Edits are kept
 *   as drafts and not sent.
 * - `greeted`: the server has sent it, but not answered the edits that were repeated on it, so that the views show no
 *   revision of the server. An edit is sent together with what it changes.
 * - `recovering`: the views show a revision; the page looks for edits that earlier pages have left unsaved.
 * - `settled`: the views show a revision, and the server has answered every edit.
 * - `dirty`: the views show a revision, with edits that aren't sent yet or aren't answered.
 */
type Phase =
  /** `isNew` tells that the page has just opened the program, and has not only come back to it. */
  | { readonly name: "closed" | "greeted"; readonly isNew: boolean }
  /** The revision that the views show, apart from the user's edits. */
  | { readonly name: "recovering" | "settled" | "dirty"; readonly revision: number };

/** The states that may follow each state. All end with a lost connection, and with another program. */
const NEXT: Readonly<Record<Phase["name"], readonly Phase["name"][]>> = {
  // With the first document.
  closed: ["closed", "greeted"],
  // When the server has answered every edit; of a new program, earlier pages may have left some.
  greeted: ["closed", "settled", "recovering"],
  // When nothing or the last of it is found; or with an edit.
  recovering: ["closed", "recovering", "settled", "dirty"],
  // With an edit; what others edit is only another revision.
  settled: ["closed", "settled", "dirty"],
  // When the server has answered every edit.
  dirty: ["closed", "settled", "dirty"],
};

/** What the three views show. */
interface Shown {
  readonly blocktext: string;
  readonly python: string;
  readonly workspace: Workspace;
}

/** The program as the page knows it. */
export interface ProgramState extends Shown {
  readonly places: readonly Place[];
  readonly problems: readonly Problem[];
  /** Views that still show the last valid program because another view has errors. */
  readonly stale: readonly View[];
  /** What answers the program's questions on the chosen robot. */
  readonly asked: readonly string[];
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
  asked: [],
  origin: "blocktext",
  canUndo: false,
  canRedo: false,
};

const VIEWS: readonly View[] = ["blocks", "blocktext", "python"];

function field(view: View): Notation | "workspace" {
  return view === "blocks" ? "workspace" : view;
}

/** The whole program in the server's first answer. */
function shownIn({ blocktext, python, workspace }: Document): Shown {
  return { blocktext: blocktext ?? "", python: python ?? "", workspace: workspace ?? EMPTY.workspace };
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
  /** Whether the server has saved every edit. Until then, they are kept as drafts. */
  readonly saved = signal(true);
  /** How many times this page has found edits that an earlier page had left unsaved. */
  readonly recovered = signal(0);
  /** Why the program can't be changed here; null if it can. */
  readonly readOnly = signal<Phrase | null>(null);
  /** The block that was copied last, as text. */
  readonly copied = new CopiedStatement();
  private project = "";
  /** The robot whose program it is; empty if it is the project's only one. */
  private tab = "";
  /** The number of the program among those that this page has shown of the project. */
  private number = 0;
  private phase: Phase = { name: "closed", isNew: false };
  private latest = EMPTY;
  /** What the views show, with the user's own edits. */
  private shown: Shown = EMPTY;
  private edits = 0;
  private answered = 0;
  /** The number of the last edit of each view. */
  private edited = new Map<View, number>();
  private readonly unsaved = new Unsaved();
  private readonly problems = new ShownProblems();
  /** Other pages' drafts, by the edit that repeats the last of them. */
  private earlier = new Map<number, () => void>();
  /** Reads and sends the views that were edited in this frame. */
  private unread = new Map<View, () => void>();
  private frame = 0;

  constructor(
    private readonly connection: Connection,
    private readonly drafts: Drafts,
  ) {
    connection.state.subscribe((state) => {
      if (state !== "open") this.disconnected();
    });
    connection.on("TabOpened", ({ tab, shown }) => this.opened(this.project, tab, shown));
    connection.on("ProjectRenamed", ({ name }) => this.renamed(name, this.tab));
    connection.on("Tabs", ({ open = "" }) => this.renamed(this.project, open));
    connection.on("Document", (document) => this.receive(document));
    connection.on("Saved", ({ edit }) => this.savedUpTo(edit));
    connection.onRefused(["EditBlocks", "EditText", "RecoverBlocks", "RecoverText"], () => this.refused());
  }

  connected(welcome: Welcome): void {
    this.readOnly.value = welcome.read_only ?? null;
  }

  reset({ name, tab = "" }: Opened): void {
    this.opened(name, tab, 0);
  }

  /** Whether the views show what the server has. */
  get settled(): boolean {
    return this.phase.name === "settled" || this.phase.name === "recovering";
  }

  /** Act once the views show what the server has, which is at once if no edit is on its way. */
  whenSettled(act: () => void): void {
    this.flush();
    if (this.settled) return act();
    const end = this.state.subscribe(() => {
      if (!this.settled) return;
      end();
      act();
    });
  }

  /** Report an edit of the workspace; `read` is called at most once per frame. */
  editedBlocks(read: () => Workspace): void {
    this.schedule("blocks", read);
  }

  /** Report an edit of a text; `read` is called at most once per frame. */
  editedText(notation: Notation, read: () => string): void {
    this.schedule(notation, read);
  }

  /** Send pending edits now, before a message that depends on them. */
  flush(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const sending = [...this.unread.values()];
    this.unread.clear();
    for (const send of sending) send();
  }

  /** Send no edits until the server has sent the program of another robot, or this one again. */
  leave(): void {
    this.flush();
    this.disconnected();
  }

  /** Show the problems of unfinished blocks, too: a run is asked for. */
  showAllProblems(): void {
    this.whenSettled(() => {
      this.state.value = { ...this.state.peek(), problems: this.problems.all() };
    });
  }

  undo(): void {
    if (this.readOnly.peek()) return;
    this.flush();
    this.connection.send({ kind: "Undo" });
  }

  redo(): void {
    if (this.readOnly.peek()) return;
    this.flush();
    this.connection.send({ kind: "Redo" });
  }

  private schedule(view: View, read: () => Content): void {
    if (this.readOnly.peek()) return;
    this.unread.set(view, () => this.edit(view, read()));
    this.becomeDirty();
    if (!this.frame) this.frame = requestAnimationFrame(() => this.flush());
  }

  private edit(view: View, content: Content): void {
    const before = this.shown[field(view)];
    this.count(view, content);
    this.unsaved.add(this.edits, view, content, before);
    this.keepDrafts();
    if ("revision" in this.phase) this.send(view, content, this.phase.revision);
    else if (this.phase.name === "greeted") this.sendWithBase({ view, content, base: before });
  }

  private count(view: View, content: Content): void {
    this.shown = { ...this.shown, [field(view)]: content };
    this.latest = { ...this.latest, [field(view)]: content };
    this.edits += 1;
    this.edited.set(view, this.edits);
  }

  private send(view: View, content: Content, revision: number): void {
    const made = { edit: this.edits, revision, shown: this.number };
    if (typeof content !== "string") this.connection.send({ kind: "EditBlocks", ...made, workspace: content });
    else if (view !== "blocks") this.connection.send({ kind: "EditText", ...made, notation: view, text: content });
  }

  /** Send an edit of a view that does not show any revision of the server, with what was edited. */
  private sendWithBase({ view, content, base }: Repeated): void {
    const made = { edit: this.edits, shown: this.number };
    if (typeof content !== "string" && typeof base !== "string") {
      this.connection.send({ kind: "RecoverBlocks", ...made, workspace: content, base });
    } else if (view !== "blocks" && typeof content === "string" && typeof base === "string") {
      this.connection.send({ kind: "RecoverText", ...made, notation: view, text: content, base });
    }
  }

  private receive(document: Document): void {
    if (this.phase.name === "closed") this.greet(document, this.phase.isNew);
    this.answered = Math.max(this.answered, document.edit);
    this.latest = {
      ...this.contents(document),
      places: document.places ?? [],
      problems: document.problems ?? [],
      stale: document.stale ?? [],
      asked: document.asked ?? [],
      origin: document.origin,
      canUndo: document.can_undo ?? false,
      canRedo: document.can_redo ?? false,
    };
    if (this.unread.size === 0 && this.answered >= this.edits) this.show(document.revision);
  }

  /** Handle the first document: repeat the edits that the server has not saved. */
  private greet(document: Document, isNew: boolean): void {
    this.become({ name: "greeted", isNew });
    this.edits = 0;
    const now = shownIn(document);
    const { drafts } = this.unsaved;
    this.unsaved.clear();
    for (const draft of drafts) {
      const edit = repeated(draft, now[field(draft.view)]);
      this.count(edit.view, edit.content);
      this.unsaved.add(this.edits, edit.view, edit.content, edit.base);
      this.sendWithBase(edit);
    }
  }

  private show(revision: number): void {
    const isNew = this.phase.name === "greeted" && this.phase.isNew;
    this.become({ name: isNew || this.phase.name === "recovering" ? "recovering" : "settled", revision });
    if (isNew) this.problems.reset();
    this.state.value = { ...this.latest, problems: this.problems.after(this.latest) };
    this.shown = this.latest;
    for (const view of VIEWS) this.unsaved.answered(view, this.shown[field(view)]);
    this.keepDrafts();
    if (isNew) void this.recover();
  }

  /** The views' contents; an answer to an earlier edit does not overwrite a later one. */
  private contents(document: Document): Shown {
    const older = (view: View) => (this.edited.get(view) ?? 0) > document.edit;
    const { blocktext, python, workspace } = this.latest;
    return {
      blocktext: older("blocktext") ? blocktext : (document.blocktext ?? blocktext),
      python: older("python") ? python : (document.python ?? python),
      workspace: older("blocks") ? workspace : (document.workspace ?? workspace),
    };
  }

  /** An edit that the server can't take in is not waited for. */
  private refused(): void {
    this.answered = this.edits;
  }

  private savedUpTo(edit: number): void {
    this.unsaved.saved(edit);
    for (const [number, forget] of this.earlier) {
      if (number > edit) continue;
      this.earlier.delete(number);
      forget();
    }
    this.keepDrafts();
  }

  private keepDrafts(): void {
    const { drafts } = this.unsaved;
    if (drafts.length > 0 || !this.saved.value) this.drafts.keep(this.key, drafts);
    this.saved.value = drafts.length === 0 && this.earlier.size === 0;
  }

  /** The drafts of each robot's program have a name of their own; projects have no slash in theirs. */
  private get key(): string {
    return this.tab ? `${this.project}/${this.tab}` : this.project;
  }

  /** The drafts move with the project and the robot. */
  private renamed(project: string, tab: string): void {
    const before = this.key;
    this.project = project;
    this.tab = tab;
    if (this.key === before) return;
    this.drafts.forget(before);
    this.drafts.keep(this.key, this.unsaved.drafts);
  }

  /** Send no edits until the server has sent the program again. */
  private disconnected(): void {
    this.become({ name: "closed", isNew: "isNew" in this.phase && this.phase.isNew });
  }

  /** The views show an edit that the server hasn't answered. */
  private becomeDirty(): void {
    if ("revision" in this.phase) this.become({ name: "dirty", revision: this.phase.revision });
  }

  private become(phase: Phase): void {
    const expected = NEXT[this.phase.name];
    if (!expected.includes(phase.name)) {
      throw new Error(`after ${this.phase.name}, expected ${expected.join(" or ")}, got ${phase.name}`);
    }
    this.phase = phase;
  }

  /** Handle an opened program: a different one, or the same one after reconnecting. */
  private opened(project: string, tab: string, number: number): void {
    const isNew = project !== this.project || tab !== this.tab;
    this.project = project;
    this.tab = tab;
    this.number = number;
    this.edits = this.answered = 0;
    this.become({ name: "closed", isNew });
    this.edited.clear();
    this.earlier.clear();
    this.latest = EMPTY;
    if (!isNew) return;
    this.unread.clear();
    this.unsaved.clear();
    this.saved.value = true;
  }

  /** Repeat the edits that other pages of this project have left unsaved. */
  private async recover(): Promise<void> {
    const { key } = this;
    // They stay in the browser until the project can be changed again.
    const left = this.readOnly.peek() ? [] : await this.drafts.left(key);
    if (key !== this.key) return;
    for (const one of left) this.repeat(one);
    if (left.length > 0) {
      this.keepDrafts();
      this.recovered.value += 1;
    }
    if (this.phase.name === "recovering") this.become({ ...this.phase, name: "settled" });
  }

  private repeat({ drafts, forget }: Left): void {
    for (const draft of drafts) {
      this.becomeDirty();
      this.edits += 1;
      this.sendWithBase(repeated(draft, this.shown[field(draft.view)]));
    }
    this.earlier.set(this.edits, forget);
  }
}
