/** The blocks that the user has made, as the page knows them, and what can be done with one as a whole. */

import { signal } from "@preact/signals";

import type { Connection } from "../connection";
import type { FromPage, OwnBlock } from "../messages";

/** What became of it: shown where it was done. */
export interface Outcome {
  readonly sort: "done" | "failed";
  /** What the server said, or a key of the translations with its values. */
  readonly message?: string;
  readonly word?: string;
  readonly values?: Readonly<Record<string, string>>;
  /** What can be done about it. */
  readonly action?: { readonly word: string; run(): void };
}

/** As long as the server takes. */
const LONGEST = 1_000_000;
const REQUESTS = [
  "DuplicateOwnBlock",
  "DeleteOwnBlock",
  "RestoreOwnBlock",
  "ExportOwnBlock",
  "ImportOwnBlock",
] as const satisfies readonly FromPage["kind"][];

export class Shelf {
  /** Null until the server has told. */
  readonly blocks = signal<readonly OwnBlock[] | null>(null);
  readonly outcome = signal<Outcome | null>(null);
  /** Says what was done once the server has done it. */
  private doing: ((name: string) => Outcome) | null = null;

  constructor(private readonly connection: Connection) {
    connection.on("Opened", () => this.list());
    connection.on("OwnBlocks", ({ blocks }) => (this.blocks.value = blocks));
    connection.on("OwnBlockSaved", ({ name }) => this.saved(name));
    connection.onRefused(REQUESTS, (message) => {
      this.doing = null;
      this.outcome.value = { sort: "failed", message };
    });
  }

  list(): void {
    this.connection.send({ kind: "ListOwnBlocks" });
  }

  find(name: string): OwnBlock | undefined {
    return this.blocks.value?.find((one) => one.name === name);
  }

  duplicate(name: string): void {
    const copy = this.freeName(name);
    this.doing = () => done("ownblocks.duplicated", { name, copy });
    this.connection.send({ kind: "DuplicateOwnBlock", name, new: copy });
  }

  delete(name: string): void {
    if (!this.connection.send({ kind: "DeleteOwnBlock", name })) return;
    const action = { word: "ownblocks.undo", run: () => this.restore(name) };
    this.outcome.value = { ...done("ownblocks.deleted", { name }), action };
  }

  export(name: string): void {
    this.connection.send({ kind: "ExportOwnBlock", name });
  }

  /** Add the block in a file; one of the same name is replaced by whoever asks for it. */
  async import(file: File): Promise<void> {
    if (file.size > LONGEST) {
      this.outcome.value = failed("ownblocks.large", { name: file.name });
      return;
    }
    const content = await file.text();
    const name = nameIn(content);
    if (!name || !this.find(name)) return this.add(content, false);
    const action = { word: "ownblocks.replace", run: () => this.add(content, true) };
    this.outcome.value = { ...failed("ownblocks.taken", { name }), action };
  }

  private add(content: string, replace: boolean): void {
    this.doing = (name) => done("ownblocks.imported", { name });
    this.connection.send({ kind: "ImportOwnBlock", content, replace });
  }

  private restore(name: string): void {
    this.doing = () => done("ownblocks.restored", { name });
    this.connection.send({ kind: "RestoreOwnBlock", name });
  }

  private saved(name: string): void {
    if (this.doing) this.outcome.value = this.doing(name);
    this.doing = null;
  }

  /** A name that no block has: the wish with a number. */
  private freeName(wish: string): string {
    let number = 2;
    while (this.find(`${wish}_${number}`)) number++;
    return `${wish}_${number}`;
  }
}

function done(word: string, values: Readonly<Record<string, string>>): Outcome {
  return { sort: "done", word, values };
}

function failed(word: string, values: Readonly<Record<string, string>>): Outcome {
  return { sort: "failed", word, values };
}

/** The name of the block in an exported file; whether it is one the server says. */
function nameIn(content: string): string | null {
  try {
    const { name } = JSON.parse(content) as { name?: unknown };
    return typeof name === "string" ? name : null;
  } catch {
    return null;
  }
}
