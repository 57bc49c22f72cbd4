/** The libraries that are installed, those that are about to be, and what one could be made of. */

import { signal } from "@preact/signals";

import { saveFile } from "../chrome/files";
import type { Connection } from "../connection";
import { t } from "../i18n";
import type { Exportable, FromPage, InstalledLibrary, LibraryRead, MakeLibrary } from "../messages";
import { fileOf, looked, renamed, type Incoming } from "./incoming";

/** What became of what was done last. */
export interface Outcome {
  readonly sort: "done" | "failed";
  /** A sentence of the server, or one of ours that is translated already. */
  readonly text: string;
}

/** How a library's file ends. */
export const ENDING = ".lblib";
/** Bytes, as many as the server takes. */
const LARGEST = 1_000_000;
const MOST = 20;
const REQUESTS = [
  "ListLibraries",
  "ReadLibraries",
  "ImportLibraries",
  "RemoveLibrary",
  "DownloadLibrary",
  "MakeLibrary",
  "UseLibrary",
] as const satisfies readonly FromPage["kind"][];

export class LibraryShelf {
  /** Null until the server has told. */
  readonly installed = signal<readonly InstalledLibrary[] | null>(null);
  readonly exportable = signal<Exportable | null>(null);
  /** Files that are about to be imported. */
  readonly incoming = signal<readonly Incoming[]>([]);
  readonly outcome = signal<Outcome | null>(null);
  /** Says what was done once the server has done it. */
  private doing: string | null = null;

  constructor(private readonly connection: Connection) {
    connection.on("Libraries", ({ libraries }) => this.told(libraries));
    connection.on("LibrariesRead", ({ files }) => this.read(files));
    connection.on("Exportable", (exportable) => (this.exportable.value = exportable));
    connection.on("LibraryMade", ({ filename, content }) => this.made(filename, content));
    connection.onRefused(REQUESTS, (message) => {
      this.doing = null;
      this.outcome.value = { sort: "failed", text: message };
    });
  }

  /** Begin anew: what is there, and what a library could be made of. */
  list(): void {
    this.outcome.value = null;
    this.connection.send({ kind: "ListLibraries" });
    this.connection.send({ kind: "ListExportable" });
  }

  // Importing.

  /** Look at files, and at those that were looked at before. */
  async take(files: readonly File[]): Promise<void> {
    this.outcome.value = null;
    const wrong = files.find((one) => !one.name.endsWith(ENDING) || one.size > LARGEST);
    if (wrong) return this.fail(t("libraries.wrongFile", { name: wrong.name }));
    if (this.incoming.value.length + files.length > MOST) return this.fail(t("libraries.tooMany", { most: MOST }));
    const found = await Promise.all(files.map(incoming));
    this.look([...this.incoming.value, ...found]);
  }

  rename(filename: string, skill: string, name: string): void {
    this.look(this.incoming.value.map((one) => (one.filename === filename ? renamed(one, skill, name) : one)));
  }

  leaveOut(filename: string): void {
    this.look(this.incoming.value.filter((one) => one.filename !== filename));
  }

  import(replace: boolean): void {
    const names = this.incoming.value.map((one) => one.read?.library?.name ?? "").join(", ");
    this.doing = t("libraries.imported", { names });
    this.connection.send({ kind: "ImportLibraries", files: this.incoming.value.map(fileOf), replace });
  }

  // What is installed.

  remove(name: string): void {
    this.doing = t("libraries.removed", { name });
    this.connection.send({ kind: "RemoveLibrary", name });
  }

  download(name: string): void {
    this.connection.send({ kind: "DownloadLibrary", name });
  }

  use(name: string): void {
    if (this.connection.send({ kind: "UseLibrary", name })) this.done(t("libraries.used", { name }));
  }

  make(library: Omit<MakeLibrary, "kind">): void {
    this.outcome.value = null;
    this.connection.send({ kind: "MakeLibrary", ...library });
  }

  // What the server tells.

  private told(libraries: readonly InstalledLibrary[]): void {
    this.installed.value = libraries;
    if (!this.doing) return;
    this.done(this.doing);
    this.doing = null;
    this.incoming.value = [];
  }

  private read(files: readonly LibraryRead[]): void {
    const known = this.incoming.value;
    // Files that were added or left out since are about to be looked at once more.
    if (files.length !== known.length || files.some((one, at) => one.filename !== known[at]?.filename)) return;
    const found = known.map((one, at) => looked(one, files[at]!));
    const suggests = found.some((one, at) => one.renamings.length > known[at]!.renamings.length);
    if (suggests) this.look(found);
    else this.incoming.value = found;
  }

  private look(files: readonly Incoming[]): void {
    this.incoming.value = files;
    if (files.length) this.connection.send({ kind: "ReadLibraries", files: files.map(fileOf) });
  }

  private made(filename: string, content: string): void {
    saveFile(filename, bytes(content), "application/zip");
    this.done(t("libraries.made", { filename }));
  }

  private done(text: string): void {
    this.outcome.value = { sort: "done", text };
  }

  private fail(text: string): void {
    this.outcome.value = { sort: "failed", text };
  }
}

async function incoming(file: File): Promise<Incoming> {
  const letters = Array.from(new Uint8Array(await file.arrayBuffer()), (byte) => String.fromCharCode(byte));
  return { filename: file.name.slice(-100), content: btoa(letters.join("")), renamings: [], read: null };
}

function bytes(content: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
}
