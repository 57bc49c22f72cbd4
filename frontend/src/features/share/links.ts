/** Links that hold a project: opened from the page's address, pasted or dropped, and compared with a run. */

import { signal } from "@preact/signals";

import { say, t } from "../../i18n";
import type { Project } from "../../model/project";
import { takeSharedLink } from "../../protocol/address";
import type { Connection } from "../../protocol/connection";
import type { RunCompared } from "../../protocol/messages";
import type { Toasts } from "../../ui/toasts";

/** What a link has, whatever its address. */
const LINK = /[#&?]share=\d+\.\w/;
/** The characters of a fingerprint that are shown. */
const SHOWN = 8;

export class Links {
  /** The last run beside that of the project's link; null before one has ended. */
  readonly compared = signal<RunCompared | null>(null);

  constructor(
    private readonly connection: Connection,
    private readonly project: Project,
    private readonly toasts: Toasts,
  ) {
    connection.on("RunCompared", (compared) => this.show(compared));
    connection.on("RunState", ({ state }) => {
      if (state === "starting") this.compared.value = null;
    });
    addEventListener("popstate", () => this.connected());
    addEventListener("paste", (event) => this.take(event, event.clipboardData));
    addEventListener("dragover", (event) => this.offers(event) && event.preventDefault());
    addEventListener("drop", (event) => this.take(event, event.dataTransfer));
  }

  /** Open the project of a link in the page's address. */
  connected(): void {
    const link = takeSharedLink();
    if (link) this.open(link);
  }

  reset(): void {
    this.compared.value = null;
  }

  open(link: string): void {
    this.connection.send({ kind: "OpenLink", link });
  }

  /** The start page takes a link anywhere but in a field. */
  private take(event: ClipboardEvent | DragEvent, data: DataTransfer | null): void {
    const isInField = event.target instanceof HTMLElement && event.target.matches("input, textarea");
    const text = data?.getData("text/plain") ?? "";
    if (!this.project.atStart.peek() || isInField || !LINK.test(text)) return;
    event.preventDefault();
    this.open(text);
  }

  private offers({ dataTransfer }: DragEvent): boolean {
    return this.project.atStart.peek() && (dataTransfer?.types.includes("text/plain") ?? false);
  }

  private show(compared: RunCompared): void {
    this.compared.value = compared;
    this.toasts.show({ sort: "note", text: comparison(compared) });
  }
}

/** The comparison in words. */
export function comparison({ same, differences = [] }: RunCompared): string {
  if (same) return t("page-share-same");
  return [t("page-share-other"), ...differences.map(say)].join(" ");
}

/** The first characters of a hash, in two groups, to compare by eye. */
export function fingerprint(hash: string): string {
  return `${hash.slice(0, SHOWN / 2)} ${hash.slice(SHOWN / 2, SHOWN)}`;
}

declare module "../../model/page" {
  interface Page {
    readonly links: Links;
  }
}
