/** The open project, and the list of all projects. */

import { effect, signal } from "@preact/signals";
import { language, type Phrase, say, t, translated, worldName } from "../i18n";
import { addressedProject, forgetProject, nameNoProject, nameProject, renameProject } from "../protocol/address";
import type { Connection } from "../protocol/connection";
import {
  type CodeOffered,
  type Conflict,
  type Export,
  type History,
  LIMITS,
  type Opened,
  type OriginalImported,
  type ProjectEntry,
  type Welcome,
  type WorldChoice,
} from "../protocol/messages";
import { inBase64, readText, saveFile } from "../ui/files";
import type { Toasts } from "../ui/toasts";
import { preferences } from "./preferences";
import type { Program } from "./program";
import type { RobotTabs } from "./robot-tabs";
import { robotTitle } from "./robots";
import { ORIGINAL, sizeProblem, stemOf, withEnding } from "./upload";

export class Project {
  /** Empty until a project is open, and on the start page. */
  readonly name = signal("");
  /** Whether the start page is shown: no project is open, nor named by the address. */
  readonly atStart = signal(addressedProject() === null);
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

  constructor(
    private readonly connection: Connection,
    private readonly program: Program,
    private readonly toasts: Toasts,
    private readonly tabs: RobotTabs,
  ) {
    connection.on("Projects", ({ projects }) => (this.entries.value = projects));
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
    connection.on("Conflict", (conflict) => this.showConflict(conflict));
    connection.on("TakenIn", () => {
      // A page that only reads follows the other one all the time.
      if (!program.readOnly.value) this.toasts.note(t("page-project-taken-in"));
    });
    connection.on("Failed", ({ message, refused = "", request = 0 }) => request || this.failed(message, refused));
    program.recovered.subscribe((times) => {
      if (times > 0) this.toasts.note(t("page-project-drafts-recovered"));
    });
    effect(() => {
      document.title = this.name.value ? `${this.name.value} – LearnBlock` : "LearnBlock";
    });
    addEventListener("popstate", () => this.followAddress());
    addEventListener("beforeunload", (event) => this.leaving(event));
  }

  /** Handle a new connection, the first one or a reconnection. */
  connected(welcome: Welcome): void {
    this.welcome.value = welcome;
    this.worlds.value = welcome.worlds;
    const name = this.name.value || addressedProject();
    if (this.name.value) this.toasts.note(t("page-project-recovered"));
    if (name) this.open(name, this.tabs.open.value);
    else this.list();
  }

  reset({ name }: Opened): void {
    this.offered.value = null;
    this.reviewing.value = false;
    this.name.value = name;
    this.atStart.value = false;
    nameProject(name);
    this.list();
  }

  open(name: string, tab = ""): void {
    this.program.flush();
    this.connection.send({ kind: "Open", name, tab });
  }

  /** Create a project of an example, or an empty one in a world. */
  create(name: string, example: string | null = null, world = ""): void {
    this.program.flush();
    this.connection.send({
      kind: "New",
      name,
      example,
      robot: preferences.value.robot,
      world,
      language: language.value,
    });
  }

  /** Open a project of an example as it is; a new one has this name. */
  openExample(name: string, example: string): void {
    this.program.flush();
    const { robot } = preferences.value;
    this.connection.send({ kind: "OpenExample", name, example, robot, language: language.value });
  }

  /** Go to the start page. */
  leave(): void {
    nameNoProject();
    this.showStart();
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

  /** Rename a project that is not open. */
  renameOther(project: string, name: string): void {
    if (name !== project) this.connection.send({ kind: "RenameProject", project, name });
  }

  /** Copy a project that need not be open. */
  copy(project: string, name: string): void {
    this.connection.send({ kind: "CopyProject", project, name });
  }

  /** Download the open project, or another one. */
  export(format: Export["format"], project = ""): void {
    this.program.flush();
    this.connection.send({ kind: "Export", format, project });
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

  /** Delete a project; if it is open, go to the start page first. */
  delete(name: string): void {
    if (name === this.name.value && !this.program.readOnly.value) {
      forgetProject();
      this.showStart();
    }
    this.connection.send({ kind: "Delete", name });
  }

  /** Import a program, and the libraries of the original LearnBlock that it may use. */
  async import(file: File, libraries: readonly File[] = []): Promise<void> {
    const large = sizeProblem([file, ...libraries]);
    if (large) return this.toasts.error(large);
    this.program.flush();
    if (withEnding([file], ORIGINAL).length === 0) {
      const text = await readText(file);
      if (text === null) return this.toasts.error(t("page-project-not-utf-8", { name: file.name }));
      this.connection.send({ kind: "Import", filename: file.name, text });
      return;
    }
    const filename = file.name.slice(-LIMITS.ImportOriginal.filename);
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

  /** A world's display name; the user's own worlds keep their names, those of our lessons are translated. */
  worldTitle(name: string): string {
    const world = this.worlds.value.find((one) => one.name === name);
    return world?.own ? worldName(world.title) : translated(`page-catalog-world-${name}`, world?.title ?? name);
  }

  /** A title for a copy of a world that no world has yet. */
  freeWorldTitle(name: string): string {
    const taken = new Set(this.worlds.value.flatMap((one) => [one.name, this.worldTitle(one.name)]));
    const title = this.worldTitle(name);
    let number = 2;
    while (taken.has(`${title} ${number}`)) number++;
    return `${title} ${number}`;
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

  private showStart(): void {
    this.atStart.value = true;
    if (this.name.value) {
      this.program.leave();
      this.connection.send({ kind: "CloseProject" });
    }
    this.name.value = "";
    this.list();
  }

  private showConflict({ version, by }: Conflict): void {
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

  /** Show a refusal; who has asked and waits for the answer shows it itself. */
  private failed(message: Phrase, refused: string): void {
    if (refused === "Run") this.refused(message);
    else this.toasts.error(say(message));
    // The page's address may name a project that does not exist.
    if (refused !== "Open") return;
    if (this.name.value) return renameProject(this.name.value);
    forgetProject();
    this.showStart();
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
    if (name === null) this.showStart();
    else if (name !== this.name.value) this.open(name);
  }
}
