/** Unsaved edits, kept by the browser so that a crash of the page, the server or the machine loses none. */

import { del, getMany, keys, set } from "idb-keyval";

import { Throttle } from "../ui/throttle";
import type { UnsavedView } from "./unsaved";

/** ms between two writes of the drafts. */
const PERIOD = 100;

/** Browsers share their database between all pages of a server: in a class, those of other pupils, too. */
function own(project: string): string {
  return `${new URL(".", location.href).pathname}${project}`;
}

/** The drafts that another page, or this one before it was reloaded, has left. */
export interface Left {
  readonly drafts: readonly UnsavedView[];
  /** Forget them once they are saved. */
  forget(): void;
}

/** Where a page keeps its drafts. */
export interface Drafts {
  /** Keep the drafts of a project instead of those before; none forgets them. */
  keep(project: string, drafts: readonly UnsavedView[]): void;
  /** Forget the drafts of a project at once. */
  forget(project: string): void;
  /** The drafts that other pages have left of a project. */
  left(project: string): Promise<readonly Left[]>;
}

/** For pages that show a program and do not edit it. */
export const NO_DRAFTS: Drafts = { keep: () => {}, forget: () => {}, left: async () => [] };

// Why: docs/decisions.md, "A page says which revision it edited"
/** Keeps drafts in the browser's database. Without one, as in some private windows, it keeps nothing. */
export class BrowserDrafts implements Drafts {
  /** Distinguishes this page's drafts from those of another page that shows the same project. */
  private readonly page = crypto.getRandomValues(new Uint32Array(2)).join("-");
  private readonly writing = new Throttle(PERIOD);
  private readonly locks = navigator.locks as LockManager | undefined;

  constructor() {
    // The browser releases the lock when the page is closed, or crashes.
    void this.locks?.request(this.page, () => new Promise(() => undefined));
  }

  keep(project: string, drafts: readonly UnsavedView[]): void {
    const key = [own(project), this.page];
    this.writing.do(() => {
      void attempt(drafts.length > 0 ? set(key, drafts) : del(key));
    });
  }

  forget(project: string): void {
    void attempt(del([own(project), this.page]));
  }

  async left(project: string): Promise<readonly Left[]> {
    const all = (await attempt(keys<[string, string]>())) ?? [];
    const open = await this.openPages();
    const others = all.filter(([name, page]) => name === own(project) && !open.has(page));
    const found = (await attempt(getMany<readonly UnsavedView[]>(others))) ?? [];
    return others.map((key, index) => ({ drafts: found[index] ?? [], forget: () => void attempt(del(key)) }));
  }

  /** The pages that will save their edits themselves; only this one where the browser has no locks. */
  private async openPages(): Promise<ReadonlySet<string | undefined>> {
    const { held = [] } = (await this.locks?.query()) ?? {};
    return new Set([this.page, ...held.map(({ name }) => name)]);
  }
}

async function attempt<T>(action: Promise<T>): Promise<T | null> {
  try {
    return await action;
  } catch (reason) {
    console.warn("The browser keeps no drafts:", reason);
    return null;
  }
}
