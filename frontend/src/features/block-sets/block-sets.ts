/** The block sets, and the chosen one. */

import { computed, signal } from "@preact/signals";
import { language, type Phrase, t } from "../../i18n";
import { DialogRequests } from "../../model/dialog-requests";
import type { Connection } from "../../protocol/connection";
import { type BlockSet, LIMITS } from "../../protocol/messages";
import type { TickedBlocks } from "./ticks";

const EVERYTHING: BlockSet = { name: "everything" };

export class BlockSets {
  readonly shown = signal<BlockSet>(EVERYTHING);
  /** The sets stored in the project. */
  readonly carried = signal<readonly BlockSet[]>([]);
  readonly ours = signal<readonly BlockSet[]>([]);
  readonly own = signal<readonly BlockSet[]>([]);
  /** Problems of files that could not be read as sets. */
  readonly problems = signal<readonly Phrase[]>([]);
  /** The set in the last file read. */
  readonly read = signal<BlockSet | null>(null);
  /** The ticks that are neither applied nor discarded. */
  readonly ticked = signal<TickedBlocks | null>(null);
  /** The set deleted last, while this can be undone. */
  readonly deleted = signal<BlockSet | null>(null);
  readonly requests: DialogRequests;
  readonly hidesSome = computed(() => this.shown.value.name !== EVERYTHING.name);

  constructor(private readonly connection: Connection) {
    this.requests = new DialogRequests(connection);
    connection.on("BlocksShown", ({ set, carried = [] }) => {
      // Rebuild the palette only if the set is a different one.
      if (JSON.stringify(set) !== JSON.stringify(this.shown.peek())) this.shown.value = set;
      this.carried.value = carried;
    });
    connection.on("BlockSets", ({ ours, own, problems = [] }) => {
      this.ours.value = ours;
      this.own.value = own;
      this.problems.value = problems;
    });
    connection.on("BlockSetRead", ({ set }) => (this.read.value = set));
  }

  reset(): void {
    this.ticked.value = null;
  }

  list(): void {
    this.read.value = this.deleted.value = null;
    void this.requests.ask({ kind: "ListBlockSets" });
  }

  choose(set: BlockSet): void {
    this.connection.send({ kind: "ChooseBlockSet", set });
  }

  save(set: BlockSet, replace: boolean): void {
    this.deleted.value = null;
    void this.requests.ask({ kind: "SaveBlockSet", set, replace });
  }

  async delete(set: BlockSet): Promise<void> {
    if (await this.requests.ask({ kind: "DeleteBlockSet", name: set.name ?? "" })) this.deleted.value = set;
  }

  export(set: BlockSet): void {
    void this.requests.ask({ kind: "ExportBlockSet", set });
  }

  /** Read a set from a file, without saving it. */
  async readFile(file: File): Promise<void> {
    const text = await this.requests.textOf(file, LIMITS.ReadBlockSet.text, t("page-sets-large", { name: file.name }));
    if (text !== null) void this.requests.ask({ kind: "ReadBlockSet", filename: file.name.slice(-100), text });
  }
}

declare module "../../model/page" {
  interface Page {
    readonly blockSets: BlockSets;
  }
}

/** A set's display name. */
export function titleOf(set: BlockSet): string {
  return worded(set.title) || (set.name ?? "");
}

export function descriptionOf(set: BlockSet): string {
  return worded(set.description);
}

function worded(texts: Readonly<Record<string, string>> = {}): string {
  return texts[language.value] ?? texts.en ?? Object.values(texts)[0] ?? "";
}
