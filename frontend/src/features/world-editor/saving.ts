/** Saving a world: its name, and the outcome. */

import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { say, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { Island } from "../../ui/island";
import type { Draft } from "./drafts";

type Outcome = { readonly word: string; readonly name: string } | { readonly text: string };

export class Saving implements Island {
  readonly dom = document.createElement("form");
  private readonly name = document.createElement("input");
  private readonly label = document.createElement("label");
  private readonly button = document.createElement("button");
  private readonly status = document.createElement("span");
  private readonly outcome = signal<Outcome | null>(null);
  private saving = "";
  /** The world that may be replaced without a question. */
  private own = "";
  private readonly endings: (() => void)[];

  /**
   * @param problems found by the server: a world with problems is not saved.
   * @param done called with the name of the saved world.
   */
  constructor(
    private readonly draft: Draft,
    private readonly connection: Connection,
    private readonly problems: ReadonlySignal<readonly unknown[]>,
    private readonly done: (name: string) => void,
  ) {
    this.build();
    const wrong = computed(() => problems.value.length > 0);
    this.endings = [
      effect(() => this.show(wrong.value)),
      connection.on("Worlds", () => this.saved()),
      connection.on("WorldChecked", ({ problems: found }) => found.length > 0 && this.refused(t("page-editor-wrong"))),
      connection.onRefused(["SaveWorld"], (reason) => this.refused(say(reason))),
    ];
  }

  /** Propose a name: the name of the edited world, if it belongs to the user. */
  propose(name: string, own: boolean): void {
    this.name.value = name;
    this.own = own ? name : "";
    this.outcome.value = null;
  }

  /** Show a message about the edited world. */
  say(word: string): void {
    this.outcome.value = { word, name: this.name.value };
  }

  destroy(): void {
    for (const end of this.endings) end();
    this.dom.remove();
  }

  private build(): void {
    this.dom.className = "editor-saving";
    this.name.required = true;
    this.name.maxLength = 40;
    this.name.pattern = "[\\p{L}\\p{N}_]([\\p{L}\\p{N}_ \\-]*[\\p{L}\\p{N}_])?";
    this.status.role = "status";
    this.label.append(document.createElement("span"), this.name);
    this.dom.append(this.label, this.button, this.status);
    this.dom.addEventListener("submit", (event) => {
      event.preventDefault();
      this.save();
    });
  }

  private show(wrong: boolean): void {
    const outcome = this.outcome.value;
    (this.label.firstChild as HTMLElement).textContent = t("page-editor-name");
    this.name.title = t("page-editor-name-rule");
    this.button.textContent = t("page-editor-save");
    this.button.disabled = wrong;
    this.status.textContent = !outcome
      ? ""
      : "text" in outcome
        ? outcome.text
        : t(outcome.word, { name: outcome.name });
  }

  private save(): void {
    const world = this.draft.world.peek();
    if (!world || this.problems.peek().length) return;
    this.saving = this.name.value;
    const replace = this.saving === this.own;
    const sent = this.connection.send({ kind: "SaveWorld", name: this.saving, world: { ...world }, replace });
    if (!sent) this.refused(t("page-editor-offline"));
  }

  private saved(): void {
    if (!this.saving) return;
    this.outcome.value = { word: "page-editor-saved", name: this.saving };
    this.own = this.saving;
    this.done(this.saving);
    this.saving = "";
  }

  private refused(text: string): void {
    if (!this.saving) return;
    // Saving under that name a second time, after the warning, replaces the world.
    this.own = this.saving;
    this.saving = "";
    this.outcome.value = { text };
  }
}
