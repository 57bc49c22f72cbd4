/** The block sets, and the chosen one. */

import { computed, signal } from "@preact/signals";
import { language, type Phrase, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { BlockSet, FromPage } from "../../protocol/messages";
import { provided } from "../../ui/provided";
import type { Draft } from "./ticks";

const EVERYTHING: BlockSet = { name: "everything" };

const REQUESTS = [
  "ListBlockSets",
  "ChooseBlockSet",
  "ReadBlockSet",
  "SaveBlockSet",
  "DeleteBlockSet",
  "ExportBlockSet",
] as const satisfies readonly FromPage["kind"][];

/** The server's limit. */
const LONGEST = 256 * 1024;

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
  readonly draft = signal<Draft | null>(null);
  /** The set deleted last, while this can be undone. */
  readonly deleted = signal<BlockSet | null>(null);
  /** Why the server refused the last request. */
  readonly refusal = signal<Phrase | string>("");
  readonly hidesSome = computed(() => this.shown.value.name !== EVERYTHING.name);

  constructor(private readonly connection: Connection) {
    connection.on("Opened", () => (this.draft.value = null));
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
    connection.onRefused(REQUESTS, (reason) => (this.refusal.value = reason));
  }

  list(): void {
    this.refusal.value = "";
    this.read.value = this.deleted.value = null;
    this.connection.send({ kind: "ListBlockSets" });
  }

  choose(set: BlockSet): void {
    this.connection.send({ kind: "ChooseBlockSet", set });
  }

  save(set: BlockSet, replace: boolean): void {
    this.refusal.value = "";
    this.deleted.value = null;
    this.connection.send({ kind: "SaveBlockSet", set, replace });
  }

  delete(set: BlockSet): void {
    this.refusal.value = "";
    if (this.connection.send({ kind: "DeleteBlockSet", name: set.name ?? "" })) this.deleted.value = set;
  }

  export(set: BlockSet): void {
    this.connection.send({ kind: "ExportBlockSet", set });
  }

  /** Read a set from a file, without saving it. */
  async readFile(file: File): Promise<void> {
    this.refusal.value = file.size > LONGEST ? t("page-sets-large", { name: file.name }) : "";
    if (this.refusal.value) return;
    this.connection.send({ kind: "ReadBlockSet", filename: file.name.slice(-100), text: await file.text() });
  }
}

export const [BlockSetsProvider, useBlockSets] = provided<BlockSets>("BlockSets");

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
