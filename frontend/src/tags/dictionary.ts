/** The dictionary of tags: names that the user has given to their numbers. */

import { signal } from "@preact/signals";

import type { Connection } from "../connection";
import { t } from "../i18n";
import type { ExportTags, FromPage } from "../messages";

export type Names = Readonly<Record<string, number>>;

const REQUESTS = ["SaveTags", "ReadTags", "ExportTags"] as const satisfies readonly FromPage["kind"][];

/** As long as the server takes. */
const LONGEST = 256 * 1024;

export class TagDictionary {
  readonly names = signal<Names>({});
  /** Why the user's file cannot be read. */
  readonly problem = signal("");
  /** The names in the file that was read last. */
  readonly read = signal<Names | null>(null);
  /** Why the server refused what was asked last. */
  readonly refusal = signal("");

  constructor(private readonly connection: Connection) {
    connection.on("Tags", ({ names, problem = "" }) => {
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

  /** Ask for the names in a file, TOML or CSV; they are not saved by that. */
  async readFile(file: File): Promise<void> {
    this.refusal.value = file.size > LONGEST ? t("tags.large", { name: file.name }) : "";
    if (this.refusal.value) return;
    this.connection.send({ kind: "ReadTags", filename: file.name.slice(-100), text: await file.text() });
  }

  export(format: ExportTags["format"]): void {
    this.refusal.value = "";
    this.connection.send({ kind: "ExportTags", format });
  }
}
