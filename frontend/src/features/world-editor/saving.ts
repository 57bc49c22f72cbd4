/** Saving a world: its name, and the outcome. */

import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { say, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import type { WorldEdit } from "./world-edit";

/** The server's limit. */
const LONGEST = 40;

type Outcome = { readonly word: string; readonly name: string } | { readonly text: string };

export class Saving implements Island {
  readonly dom = document.createElement("form");
  private readonly name = document.createElement("input");
  private readonly label = document.createElement("label");
  private readonly button = document.createElement("button");
  private readonly status = document.createElement("span");
  private readonly outcome = signal<Outcome | null>(null);
  /** The user's world that is edited: what its field says, and the name of its file. */
  private own = { title: "", name: "" };
  private readonly cleanup: Cleanup;

  /**
   * @param problems found by the server: a world with problems is not saved.
   * @param done called with the name and the title of the saved world.
   */
  constructor(
    private readonly draft: WorldEdit,
    private readonly connection: Connection,
    private readonly problems: ReadonlySignal<readonly unknown[]>,
    private readonly done: (name: string, title: string) => void,
  ) {
    this.build();
    const wrong = computed(() => problems.value.length > 0);
    this.cleanup = new Cleanup(effect(() => this.show(wrong.value)));
  }

  /** Propose a title for the world; `own` is the file's name if the world belongs to the user. */
  propose(title: string, own = ""): void {
    this.name.value = title;
    this.own = own ? { title, name: own } : { title: "", name: "" };
    this.outcome.value = null;
  }

  /** Show a message about the edited world. */
  say(word: string): void {
    this.outcome.value = { word, name: this.name.value };
  }

  destroy(): void {
    this.cleanup.dispose();
    this.dom.remove();
  }

  private build(): void {
    this.dom.className = "editor-saving";
    this.name.required = true;
    this.name.maxLength = LONGEST;
    this.name.pattern = ".*[\\p{L}\\p{N}_].*";
    this.status.role = "status";
    this.label.append(document.createElement("span"), this.name);
    this.dom.append(this.label, this.button, this.status);
    this.dom.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.save();
    });
  }

  private show(wrong: boolean): void {
    const outcome = this.outcome.value;
    (this.label.firstChild as HTMLElement).textContent = this.name.ariaLabel = t("page-editor-name");
    this.name.title = t("page-editor-name-rule");
    this.button.textContent = t("page-editor-save");
    this.button.disabled = wrong;
    this.status.textContent = !outcome
      ? ""
      : "text" in outcome
        ? outcome.text
        : t(outcome.word, { name: outcome.name });
  }

  private async save(): Promise<void> {
    const world = this.draft.world.peek();
    if (!world || this.problems.peek().length) return;
    const title = this.name.value.trim();
    const replace = title === this.own.title;
    const name = replace ? this.own.name : fileName(title);
    // The list of worlds shows what the user has typed here.
    const answer = await this.connection.ask({ kind: "SaveWorld", name, world: { ...world, title }, replace });
    // Saving under that name a second time, after the warning, replaces the world.
    this.own = { title, name };
    if (answer.kind === "Failed") this.outcome.value = { text: say(answer.message) };
    else if (answer.kind === "WorldChecked") this.outcome.value = { text: t("page-editor-wrong") };
    else this.done(name, title);
  }
}

/** The name of the file of a world with this title, as the server allows it. */
export function fileName(title: string): string {
  const plain = title
    .normalize("NFC")
    .replace(/[^\p{L}\p{N}_-]+/gu, " ")
    .slice(0, LONGEST);
  return plain.replace(/^[ -]+|[ -]+$/g, "");
}
