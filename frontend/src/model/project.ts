/** The open project, and the list of all projects. */

import { effect, signal } from "@preact/signals";
import { type Phrase, say, t, translated } from "../i18n";
import { addressedProject, nameProject, renameProject } from "../protocol/address";
import type { Connection } from "../protocol/connection";
import type {
  CodeOffered,
  Conflict,
  Export,
  History,
  OriginalImported,
  ProjectEntry,
  Welcome,
  WorldChoice,
} from "../protocol/messages";
import { inBase64, saveFile } from "../ui/files";
import type { Toasts } from "../ui/toasts";
import type { Program } from "./program";
import { robotTitle } from "./robots";
import { ORIGINAL, sizeProblem, stemOf, withEnding } from "./upload";

/** The example that new users see. */
const FIRST_EXAMPLE = "square";
const LONGEST_NAME = 100;

export class Project {
  readonly name = signal("");
  readonly welcome = signal<Welcome | null>(null);
  readonly worlds = signal<readonly WorldChoice[]>([]);
  /** Null until the server has sent it. */
  readonly entries = signal<readonly ProjectEntry[] | null>(null);
  readonly history = signal<History | null>(null);
  /** What the last import changed, until the user has read it. */
  readonly imported = signal<OriginalImported | null>(null);
  /** The code that the project brings and the user has not installed. */
  readonly offered = signal<CodeOffered | null>(null);
  /** Whether the user is reading that code. */
  readonly reviewing = signal(false);
  /** Whether to choose a project when the list arrives. */
  private choosing = false;
  /** The project to delete once another one is open. */
  private doomed: string | null = null;

  constructor(
    private readonly connection: Connection,
    private readonly program: Program,
    private readonly toasts: Toasts,
  ) {
    connection.on("Welcome", (welcome) => this.begin(welcome));
    connection.on("Projects", ({ projects }) => this.listed(projects));
    connection.on("Opened", ({ name }) => this.opened(name));
    connection.on("ProjectRenamed", ({ name }) => this.renamed(name));
    connection.on("Robots", ({ robots }) => (this.welcome.value &&= { ...this.welcome.value, robots }));
    connection.on("Worlds", ({ worlds }) => (this.worlds.value = worlds));
    connection.on("History", (history) => (this.history.value = history));
    connection.on("OriginalImported", (report) => {
      if (report.changed.length + report.missing.length) this.imported.value = report;
    });
    connection.on("File", ({ filename, text }) => saveFile(filename, text, "text/plain"));
    connection.on("CodeOffered", (offered) => this.offer(offered));
    connection.on("Noted", ({ message }) => this.toasts.note(say(message)));
    connection.on("Conflict", (conflict) => this.tellConflict(conflict));
    connection.on("TakenIn", () => {
      // A page that only reads follows the other one all the time.
      if (!program.readOnly.value) this.toasts.note(t("page-project-taken-in"));
    });
    connection.on("Failed", ({ message, request }) => this.failed(message, request ?? ""));
    program.recovered.subscribe((times) => {
      if (times > 0) this.toasts.note(t("page-project-drafts-recovered"));
    });
    effect(() => {
      document.title = this.name.value ? `${this.name.value} – LearnBlock` : "LearnBlock";
    });
    addEventListener("popstate", () => this.followAddress());
    addEventListener("beforeunload", (event) => this.leaving(event));
  }

  open(name: string): void {
    this.program.flush();
    this.connection.send({ kind: "Open", name });
  }

  create(name: string, example: string | null = null): void {
    this.program.flush();
    this.connection.send({ kind: "New", name, example });
  }

  saveAs(name: string): void {
    this.program.flush();
    this.connection.send({ kind: "SaveAs", name });
  }

  rename(name: string): void {
    if (name === this.name.value) return;
    this.program.flush();
    this.connection.send({ kind: "RenameProject", name });
  }

  export(format: Export["format"]): void {
    this.program.flush();
    this.connection.send({ kind: "Export", format });
  }

  restore(version: string): void {
    this.program.flush();
    this.connection.send({ kind: "Restore", version });
  }

  list(): void {
    this.connection.send({ kind: "ListProjects" });
  }

  listHistory(): void {
    this.history.value = null;
    this.connection.send({ kind: "ListHistory" });
  }

  /** Delete a project; if it is open, open another one first. */
  delete(name: string): void {
    if (name === this.name.value) {
      this.doomed = name;
      this.choosing = true;
    } else {
      this.connection.send({ kind: "Delete", name });
    }
    this.list();
  }

  /** Import a program, and the libraries of the original LearnBlock that it may use. */
  async import(file: File, libraries: readonly File[] = []): Promise<void> {
    const large = sizeProblem([file, ...libraries]);
    if (large) return this.toasts.error(large);
    this.program.flush();
    if (withEnding([file], ORIGINAL).length === 0) {
      this.connection.send({ kind: "Import", filename: file.name, text: await file.text() });
      return;
    }
    const filename = file.name.slice(-LONGEST_NAME);
    const texts = await Promise.all(libraries.map(async (one) => [stemOf(one), await inBase64(one)]));
    const content = await inBase64(file);
    this.connection.send({ kind: "ImportOriginal", filename, content, libraries: Object.fromEntries(texts) });
  }

  /** Install the code that the project brings. */
  installOffered(): void {
    this.connection.send({ kind: "InstallOffered" });
  }

  /** A robot's display name. */
  robotTitle(name: string): string {
    const robot = this.welcome.value?.robots.find((one) => one.name === name);
    return robot ? robotTitle(robot) : name;
  }

  /** A world's display name; the user's own worlds keep their names. */
  worldTitle(name: string): string {
    const world = this.worlds.value.find((one) => one.name === name);
    return world?.own ? world.title : translated(`page-catalog-world-${name}`, world?.title ?? name);
  }

  /** A title for a copy of a world that no world has yet. */
  freeWorldTitle(name: string): string {
    const taken = new Set(this.worlds.value.flatMap((one) => [one.name, this.worldTitle(one.name)]));
    const title = this.worldTitle(name);
    let number = 2;
    while (taken.has(`${title} ${number}`)) number++;
    return `${title} ${number}`;
  }

  /** Handle a new connection, the first one or a reconnection. */
  private begin(welcome: Welcome): void {
    this.welcome.value = welcome;
    this.worlds.value = welcome.worlds;
    const name = this.name.value || addressedProject();
    if (this.name.value) this.toasts.note(t("page-project-recovered"));
    if (name) return this.open(name);
    this.choosing = true;
    this.list();
  }

  private offer(offered: CodeOffered): void {
    const names = [...(offered.blocks ?? []), ...(offered.libraries ?? [])].map((one) => one.name);
    if (names.length === 0) {
      if (this.offered.value) this.toasts.note(t("page-project-offered-done"));
      this.offered.value = null;
      return;
    }
    this.offered.value = offered;
    this.toasts.show({
      sort: "note",
      text: t("page-project-offered", { names: names.join(", ") }),
      action: { text: t("page-project-offered-review"), run: () => (this.reviewing.value = true) },
    });
  }

  private listed(projects: readonly ProjectEntry[]): void {
    this.entries.value = projects;
    if (!this.choosing) return;
    this.choosing = false;
    const last = projects.find((one) => one.name !== this.doomed);
    if (last) this.open(last.name);
    else this.create(FIRST_EXAMPLE, FIRST_EXAMPLE);
  }

  private opened(name: string): void {
    this.offered.value = null;
    this.reviewing.value = false;
    this.name.value = name;
    nameProject(name);
    if (this.doomed && this.doomed !== name) this.connection.send({ kind: "Delete", name: this.doomed });
    this.doomed = null;
    this.list();
  }

  private tellConflict({ version, by }: Conflict): void {
    const action = { text: t("page-project-take-other"), run: () => this.restore(version) };
    const text = t(`page-project-conflict-${by}`);
    this.toasts.show(version ? { sort: "error", text, action } : { sort: "error", text });
  }

  /** Let the browser ask before it closes a page whose edits are not saved. */
  private leaving(event: BeforeUnloadEvent): void {
    this.program.flush();
    if (!this.program.saved.value) event.preventDefault();
  }

  private renamed(name: string): void {
    this.name.value = name;
    renameProject(name);
    this.list();
  }

  private failed(message: Phrase, request: string): void {
    // The dialog that sent the request shows the error itself.
    if (/(CustomBlock|Library|Libraries)$/.test(request)) return;
    if (request === "Run") this.refused(message);
    else this.toasts.error(say(message));
    this.doomed = null;
    // The page's address names a project that does not exist.
    if (request !== "Open") return;
    if (this.name.value) return renameProject(this.name.value);
    this.choosing = true;
    this.list();
  }

  /** Tell why the program cannot run, until its error is fixed. */
  private refused(message: Phrase): void {
    const error = say((message.values?.problem ?? "") as Phrase | string);
    const isFixed = () => !this.program.state.value.problems.some((one) => say(one.message) === error);
    if (isFixed()) this.toasts.error(say(message));
    else this.toasts.errorUntil(isFixed, say(message));
  }

  private followAddress(): void {
    const name = addressedProject();
    if (name && name !== this.name.value) this.open(name);
  }
}
