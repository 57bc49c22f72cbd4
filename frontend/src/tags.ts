/** The dictionary of tags as the page knows it. */

import { signal } from "@preact/signals";

import type { Connection } from "./connection";

export class TagNames {
  /** The number of each name. */
  readonly names = signal<Readonly<Record<string, number>>>({});

  constructor(connection: Connection) {
    connection.on("Tags", ({ names }) => (this.names.value = names));
  }
}
