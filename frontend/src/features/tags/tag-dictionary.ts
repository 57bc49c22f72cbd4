/** The tag dictionary: the user's names for tag numbers. */

import { signal } from "@preact/signals";
import { type Phrase, t } from "../../i18n";
import { DialogRequests } from "../../model/dialog-requests";
import type { Connection } from "../../protocol/connection";
import { type ExportTags, LIMITS } from "../../protocol/messages";

export type Names = Readonly<Record<string, number>>;

export class TagDictionary {
  readonly names = signal<Names>({});
  /** Why the user's file cannot be read. */
  readonly problem = signal<Phrase | null>(null);
  /** The names in the file that was read last. */
  readonly read = signal<Names | null>(null);
  readonly requests: DialogRequests;

  constructor(connection: Connection) {
    this.requests = new DialogRequests(connection);
    connection.on("Tags", ({ names, problem = null }) => {
      this.names.value = names;
      this.problem.value = problem;
    });
    connection.on("TagsRead", ({ names }) => (this.read.value = names));
  }

  save(names: Names): void {
    void this.requests.ask({ kind: "SaveTags", names });
  }

  /** Read the names in a TOML or CSV file, without saving them. */
  async readFile(file: File): Promise<void> {
    const text = await this.requests.textOf(file, LIMITS.ReadTags.text, t("page-tags-large", { name: file.name }));
    if (text !== null) void this.requests.ask({ kind: "ReadTags", filename: file.name.slice(-100), text });
  }

  export(format: ExportTags["format"]): void {
    void this.requests.ask({ kind: "ExportTags", format });
  }
}

declare module "../../model/page" {
  interface Page {
    readonly tags: TagDictionary;
  }
}
