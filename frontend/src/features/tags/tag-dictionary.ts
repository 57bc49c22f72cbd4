/** The tag dictionary: the user's names for tag numbers. */

import { signal } from "@preact/signals";
import { type Phrase, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { ExportTags, FromPage } from "../../protocol/messages";
import { provided } from "../../ui/provided";

export type Names = Readonly<Record<string, number>>;

const REQUESTS = ["SaveTags", "ReadTags", "ExportTags"] as const satisfies readonly FromPage["kind"][];

/** The server's limit. */
const LONGEST = 256 * 1024;

export class TagDictionary {
  readonly names = signal<Names>({});
  /** Why the user's file cannot be read. */
  readonly problem = signal<Phrase | null>(null);
  /** The names in the file that was read last. */
  readonly read = signal<Names | null>(null);
  /** Why the server refused the last request. */
  readonly refusal = signal<Phrase | string>("");

  constructor(private readonly connection: Connection) {
    connection.on("Tags", ({ names, problem = null }) => {
      this.names.value = names;
      this.problem.value = problem;
    });
    connection.on("TagsRead", ({ names }) => (this.read.value = names));
    connection.onRefused(REQUESTS, (reason) => (this.refusal.value = reason));
  }

  save(names: Names): void {
    this.refusal.value = "";
    this.connection.send({ kind: "SaveTags", names });
  }

  /** Read the names in a TOML or CSV file, without saving them. */
  async readFile(file: File): Promise<void> {
    this.refusal.value = file.size > LONGEST ? t("page-tags-large", { name: file.name }) : "";
    if (this.refusal.value) return;
    this.connection.send({ kind: "ReadTags", filename: file.name.slice(-100), text: await file.text() });
  }

  export(format: ExportTags["format"]): void {
    this.refusal.value = "";
    this.connection.send({ kind: "ExportTags", format });
  }
}

export const [TagDictionaryProvider, useTagDictionary] = provided<TagDictionary>("TagDictionary");
