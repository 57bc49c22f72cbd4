/** The teacher's classes, which are open on this computer or kept there. */

import { signal } from "@preact/signals";

import { type Phrase, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { ClassEntry, StartClass } from "../../protocol/messages";
import { sendFile, UNSENT } from "../../protocol/send-file";
import { weekday } from "../../ui/dates";

/** The ending of the file of a class. */
export const CLASS_FILE = ".lbclass";

type Wanted = Omit<StartClass, "kind" | "request">;

export class Classes {
  /** Whether the start page shows what is for teachers. */
  readonly shown = signal(false);
  /** Null until the server has sent them. */
  readonly entries = signal<readonly ClassEntry[] | null>(null);
  /** The class that is being opened, closed, deleted or taken in. */
  readonly busy = signal("");
  readonly problem = signal<Phrase | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("Classes", ({ classes }) => (this.entries.value = classes));
  }

  list(): void {
    void this.connection.ask({ kind: "ListClasses" });
  }

  /** Open a class, and its wall beside this page. */
  async start(wanted: Wanted): Promise<void> {
    // At once, because a browser lets a page open another one only for some seconds after a click.
    const tab = window.open("", "_blank");
    if (tab) tab.document.body.textContent = t("page-teachers-opening");
    const answer = await this.during(wanted.title, () => this.connection.ask({ kind: "StartClass", ...wanted }));
    if (answer.kind === "ClassOpened") tab?.location.assign(answer.wall);
    else tab?.close();
  }

  async close(title: string): Promise<void> {
    await this.during(title, () => this.connection.ask({ kind: "CloseClass", title }));
  }

  async delete(title: string): Promise<void> {
    await this.during(title, () => this.connection.ask({ kind: "DeleteClass", title }));
  }

  /** Take in a class from its file. */
  async takeIn(file: File): Promise<void> {
    await this.during(file.name, async () => {
      const { answer, refusal } = await sendFile<string>("classes", file);
      return answer ? { kind: "Done" } : { kind: "Failed", message: refusal ?? UNSENT };
    });
    this.list();
  }

  /** Do something with a class, and keep what is wrong with it. */
  private async during<Answer extends { kind: string; message?: Phrase }>(
    title: string,
    act: () => Promise<Answer>,
  ): Promise<Answer> {
    this.busy.value = title;
    this.problem.value = null;
    const answer = await act();
    this.busy.value = "";
    if (answer.kind === "Failed") this.problem.value = answer.message ?? null;
    return answer;
  }
}

/** A name that no class has yet: that of the day, and a number if it is taken. */
export function newTitle(entries: readonly ClassEntry[], now = new Date()): string {
  const titles = new Set(entries.map(({ title }) => title));
  // The name of a class is that of a folder, too.
  const today = weekday(now).replace(/[^\p{L}\p{N} .-]/gu, "");
  let number = 1;
  let title = today;
  while (titles.has(title)) title = `${today} ${++number}`;
  return title;
}

declare module "../../model/page" {
  interface Page {
    readonly classes: Classes;
  }
}
