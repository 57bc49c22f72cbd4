/** The installed libraries, the files to import, and the parts for a new library. */

import { signal } from "@preact/signals";
import { type Phrase, t } from "../../i18n";
import { LIBRARY, ORIGINAL_LIBRARY, sizeProblem, stemOf, withEnding } from "../../model/upload";
import type { Connection } from "../../protocol/connection";
import {
  type Exportable,
  type FromPage,
  type InstalledLibrary,
  LIMITS,
  type LibraryConverted,
  type LibraryRead,
  type MakeLibrary,
} from "../../protocol/messages";
import { bytesOf, inBase64, saveFile } from "../../ui/files";
import { fileOf, type Incoming, renamed, withAnswer } from "./incoming";
import { conversion, looseIn, originalsIn } from "./originals";

/** The outcome of the last action. */
export interface Outcome {
  readonly sort: "done" | "failed";
  /** The server's message, or a translated text of the page. */
  readonly text: Phrase | string;
}

const MOST = LIMITS.ImportLibraries.files;

export class Libraries {
  /** Null until the server has sent it. */
  readonly installed = signal<readonly InstalledLibrary[] | null>(null);
  readonly exportable = signal<Exportable | null>(null);
  /** The files to import. */
  readonly incoming = signal<readonly Incoming[]>([]);
  readonly outcome = signal<Outcome | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("Libraries", ({ libraries }) => (this.installed.value = libraries));
    connection.on("LibrariesRead", ({ files }) => this.read(files));
    connection.on("Exportable", (exportable) => (this.exportable.value = exportable));
    connection.on("LibraryMade", ({ filename, content }) => this.made(filename, content));
    connection.on("LibraryConverted", (library) => this.converted(library));
  }

  /** Ask for the installed libraries and the parts for a new one. */
  list(): void {
    void this.do({ kind: "ListLibraries" });
    this.connection.send({ kind: "ListExportable" });
  }

  /** Forget what was not imported. */
  leave(): void {
    this.outcome.value = null;
    this.incoming.value = [];
  }

  // Importing.

  /** Let the server read files, together with those read before. */
  async take(files: readonly File[]): Promise<void> {
    this.outcome.value = null;
    const originals = originalsIn(files);
    const packed = withEnding(files, [LIBRARY]);
    const problem = wrongFile(files) ?? sizeProblem(files);
    if (problem) return this.fail(problem);
    if (this.incoming.value.length + packed.length + originals.length > MOST)
      return this.fail(t("page-libraries-too-many", { most: MOST }));
    for (const one of originals) void this.do(await conversion(one));
    if (packed.length) this.look([...this.incoming.value, ...(await Promise.all(packed.map(incoming)))]);
  }

  rename(filename: string, skill: string, name: string): void {
    this.look(this.incoming.value.map((one) => (one.filename === filename ? renamed(one, skill, name) : one)));
  }

  leaveOut(filename: string): void {
    this.look(this.incoming.value.filter((one) => one.filename !== filename));
  }

  async import(replace: boolean): Promise<void> {
    const names = this.incoming.value.map((one) => one.read?.library?.name ?? "").join(", ");
    const files = this.incoming.value.map(fileOf);
    const imported = await this.do(
      { kind: "ImportLibraries", files, replace },
      t("page-libraries-imported", { names }),
    );
    if (imported) this.incoming.value = [];
  }

  // The installed libraries.

  remove(name: string): void {
    void this.do({ kind: "RemoveLibrary", name }, t("page-libraries-removed", { name }));
  }

  download(name: string): void {
    void this.do({ kind: "DownloadLibrary", name });
  }

  use(name: string): void {
    void this.do({ kind: "UseLibrary", name }, t("page-libraries-used", { name }));
  }

  make(library: Omit<MakeLibrary, "kind">): void {
    this.outcome.value = null;
    void this.do({ kind: "MakeLibrary", ...library });
  }

  /** Let the server do something, and show its outcome: this text, or why it was refused. */
  private async do(message: FromPage, text = ""): Promise<boolean> {
    const answer = await this.connection.ask(message);
    if (answer.kind === "Failed") this.outcome.value = { sort: "failed", text: answer.message };
    else if (text) this.done(text);
    return answer.kind !== "Failed";
  }

  // The server's answers.

  private read(files: readonly LibraryRead[]): void {
    const known = this.incoming.value;
    // Files were added or removed since: another answer is coming.
    if (files.length !== known.length || files.some((one, at) => one.filename !== known[at]?.filename)) return;
    const found = known.map((one, at) => withAnswer(one, files[at]!));
    const suggests = found.some((one, at) => one.renamings.length > known[at]!.renamings.length);
    if (suggests) this.look(found);
    else this.incoming.value = found;
  }

  private converted({ filename, content, changed, missing }: LibraryConverted): void {
    this.look([...this.incoming.value, { filename, content, changed, missing, renamings: [], read: null }]);
  }

  private look(files: readonly Incoming[]): void {
    this.incoming.value = files;
    if (files.length) void this.do({ kind: "ReadLibraries", files: files.map(fileOf) });
  }

  private made(filename: string, content: string): void {
    saveFile(filename, bytesOf(content), "application/zip");
    this.done(t("page-libraries-made", { filename }));
  }

  private done(text: string): void {
    this.outcome.value = { sort: "done", text };
  }

  private fail(text: string): void {
    this.outcome.value = { sort: "failed", text };
  }
}

declare module "../../model/page" {
  interface Page {
    readonly libraries: Libraries;
  }
}

/** The endings of the files that can be imported. */
export const ENDINGS = [LIBRARY, ...ORIGINAL_LIBRARY];

/** Why the files are not libraries; null if they are. */
function wrongFile(files: readonly File[]): string | null {
  const wrong = files.find((one) => withEnding([one], ENDINGS).length === 0);
  if (wrong) return t("page-libraries-wrong-file", { name: wrong.name });
  const loose = looseIn(files);
  return loose ? t("page-libraries-part", { name: loose.name, needed: `${stemOf(loose)}.lb` }) : null;
}

async function incoming(file: File): Promise<Incoming> {
  return { filename: file.name.slice(-100), content: await inBase64(file), renamings: [], read: null };
}
