/** The sets of blocks that one can choose, and the one that is chosen. */

import { computed, signal } from "@preact/signals";

import type { Connection } from "../connection";
import { language, t } from "../i18n";
import type { BlockSet, FromPage } from "../messages";
import type { Draft } from "./ticks";

export const EVERYTHING: BlockSet = { name: "everything" };

const REQUESTS = [
  "ListBlockSets",
  "ChooseBlockSet",
  "ReadBlockSet",
  "SaveBlockSet",
  "DeleteBlockSet",
  "ExportBlockSet",
] as const satisfies readonly FromPage["kind"][];

/** As long as the server takes. */
const LONGEST = 256 * 1024;

export class BlockSetLibrary {
  readonly shown = signal<BlockSet>(EVERYTHING);
  /** Those that the project takes along. */
  readonly carried = signal<readonly BlockSet[]>([]);
  readonly ours = signal<readonly BlockSet[]>([]);
  readonly own = signal<readonly BlockSet[]>([]);
  /** Of files that are no sets. */
  readonly problems = signal<readonly string[]>([]);
  /** The set of the file that was read last. */
  readonly read = signal<BlockSet | null>(null);
  /** What was ticked and neither used nor given up. */
  readonly draft = signal<Draft | null>(null);
  /** The one that was deleted last, as long as that can be taken back. */
  readonly deleted = signal<BlockSet | null>(null);
  /** Why the server refused what was asked last. */
  readonly refusal = signal("");
  readonly hidesSome = computed(() => this.shown.value.name !== EVERYTHING.name);

  constructor(private readonly connection: Connection) {
    connection.on("Opened", () => (this.draft.value = null));
    connection.on("BlocksShown", ({ set, carried = [] }) => {
      // The palette is made anew for another set, and for no other reason.
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

  /** Read a set from a file; it is not saved by that. */
  async readFile(file: File): Promise<void> {
    this.refusal.value = file.size > LONGEST ? t("blocksets.large", { name: file.name }) : "";
    if (this.refusal.value) return;
    this.connection.send({ kind: "ReadBlockSet", filename: file.name.slice(-100), text: await file.text() });
  }
}

/** A set's name for a person. */
export function titleOf(set: BlockSet): string {
  return worded(set.title) || (set.name ?? "");
}

export function descriptionOf(set: BlockSet): string {
  return worded(set.description);
}

function worded(texts: Readonly<Record<string, string>> = {}): string {
  return texts[language.value] ?? texts["en"] ?? Object.values(texts)[0] ?? "";
}
