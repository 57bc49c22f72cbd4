/** The user's custom blocks, and actions on a whole block. */

import { signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import { type CustomBlock, type FromPage, LIMITS } from "../../protocol/messages";
import { readText } from "../../ui/files";

/** The outcome of an action, shown in its dialog. */
export interface Outcome {
  readonly sort: "done" | "failed";
  /** The server's message, or the key of a text with its values. */
  readonly message?: Phrase;
  readonly word?: string;
  readonly values?: Readonly<Record<string, string>>;
  /** The actions that the user can take. */
  readonly action?: { readonly word: string; run(): void };
}

export class CustomBlocks {
  /** Null until the server has sent it. */
  readonly blocks = signal<readonly CustomBlock[] | null>(null);
  readonly outcome = signal<Outcome | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("CustomBlocks", ({ blocks }) => (this.blocks.value = blocks));
  }

  reset(): void {
    this.list();
  }

  list(): void {
    this.connection.send({ kind: "ListCustomBlocks" });
  }

  find(name: string): CustomBlock | undefined {
    return this.blocks.value?.find((one) => one.name === name);
  }

  duplicate(name: string): void {
    const copy = this.freeName(name);
    void this.do({ kind: "DuplicateCustomBlock", name, new: copy }, done("page-custom-duplicated", { name, copy }));
  }

  delete(name: string): void {
    const action = { word: "page-custom-undo", run: () => this.restore(name) };
    void this.do({ kind: "DeleteCustomBlock", name }, { ...done("page-custom-deleted", { name }), action });
  }

  export(name: string): void {
    void this.do({ kind: "ExportCustomBlock", name }, null);
  }

  /** Import a block from a file; the user must confirm before it replaces one with the same name. */
  async import(file: File): Promise<void> {
    if (file.size > LIMITS.ImportCustomBlock.content) {
      this.outcome.value = failed("page-custom-large", { name: file.name });
      return;
    }
    const content = await readText(file);
    if (content === null) {
      this.outcome.value = failed("page-project-not-utf-8", { name: file.name });
      return;
    }
    const name = nameIn(content);
    if (!name || !this.find(name)) return this.add(content, name ?? "", false);
    const action = { word: "page-custom-replace", run: () => this.add(content, name, true) };
    this.outcome.value = { ...failed("page-custom-taken", { name }), action };
  }

  private add(content: string, name: string, replace: boolean): void {
    void this.do({ kind: "ImportCustomBlock", content, replace }, done("page-custom-imported", { name }));
  }

  private restore(name: string): void {
    void this.do({ kind: "RestoreCustomBlock", name }, done("page-custom-restored", { name }));
  }

  /** Let the server do something, and show its outcome: this one, or why it was refused. */
  private async do(message: FromPage, outcome: Outcome | null): Promise<void> {
    const answer = await this.connection.ask(message);
    if (answer.kind === "Failed") this.outcome.value = { sort: "failed", message: answer.message };
    else if (outcome) this.outcome.value = outcome;
  }

  /** An unused name: the requested one plus a number. */
  private freeName(wish: string): string {
    let number = 2;
    while (this.find(`${wish}_${number}`)) number++;
    return `${wish}_${number}`;
  }
}

declare module "../../model/page" {
  interface Page {
    readonly customBlocks: CustomBlocks;
  }
}

function done(word: string, values: Readonly<Record<string, string>>): Outcome {
  return { sort: "done", word, values };
}

function failed(word: string, values: Readonly<Record<string, string>>): Outcome {
  return { sort: "failed", word, values };
}

/** The name of the block in an exported file; the server checks whether it is valid. */
function nameIn(content: string): string | null {
  try {
    const { name } = JSON.parse(content) as { name?: unknown };
    return typeof name === "string" ? name : null;
  } catch {
    return null;
  }
}
