/** A block that is being edited: its source, the server's checks, and saving. */

import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { language, type Phrase, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type {
  CustomBlock,
  CustomBlockChecked,
  CustomBlockPreview,
  CustomBlockProblem,
  SaveCustomBlock,
} from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import { UnsavedEdits } from "../../ui/storage";
import { Throttle } from "../../ui/throttle";
import { blocksIn, type Configured, withBlock } from "./configuration";

/** ms between two requests for a check. */
const PERIOD = 300;

/** The editable parts of a custom block. */
export interface Written {
  /** The name of its file. */
  readonly name: string;
  readonly source: string;
  /** JSON; empty for the defaults. */
  readonly configuration: string;
}

/** By the name that a block was saved under; a new block has the empty name. */
const UNSAVED = new UnsavedEdits<Written>("learnblock.ownblocks");

export class CustomBlockEdit {
  readonly written = signal<Written>({ name: "", source: "", configuration: "" });
  /** The name that it is saved under; empty if it was never saved. */
  readonly saved = signal("");
  readonly checked = signal<CustomBlockChecked | null>(null);
  /** Whether it continues an unsaved edit. */
  readonly restored = signal(false);
  /** The outcome of saving: a name, or the reason for the failure. */
  readonly outcome = signal<{ readonly saved: string } | { readonly refused: Phrase | string } | null>(null);

  readonly problems = computed<readonly CustomBlockProblem[]>(() => this.checked.value?.problems ?? []);
  /** The preview of the last source without syntax errors. */
  readonly blocks = signal<readonly Configured[]>([]);
  readonly previews = signal<readonly CustomBlockPreview[]>([]);
  /** As JSON: the user's own, else derived from the source by the server. */
  readonly configuration = computed(
    () => this.written.value.configuration || (this.checked.value?.configuration ?? ""),
  );
  /** Whether the server's answer is about the current text. */
  readonly current = computed(() => this.answered.value === this.written.value);
  readonly dirty = computed(() => !same(this.written.value, this.original.value));

  private readonly original = signal<Written>(this.written.peek());
  private readonly asking = new Throttle(PERIOD);
  /** The configuration without what the source defines; choices in the form go into it. */
  private chosen = "";
  private readonly answered = signal<Written | null>(null);
  /** Whether to save it when the server has answered. */
  private waiting = false;
  /** Whether the name follows the function's name, until the user types one. */
  private named = false;
  private readonly cleanup: Cleanup;

  constructor(private readonly connection: Connection) {
    this.cleanup = new Cleanup(effect(() => this.check(language.value, this.written.value, this.saved.value)));
  }

  destroy(): void {
    this.cleanup.dispose();
    this.asking.cancel();
  }

  /** Edit a saved block. */
  open({ name, source, configuration }: CustomBlock): void {
    this.begin(name, { name, source, configuration });
  }

  /** Edit a new block. */
  create(source: string): void {
    this.begin("", { name: "", source, configuration: "" });
  }

  change(change: Partial<Written>): void {
    if (change.name !== undefined) this.named = true;
    this.written.value = { ...this.written.value, ...change };
    this.outcome.value = null;
  }

  /** Change the configuration of one of its functions. */
  configure(name: string, change: (block: Configured) => Configured): void {
    this.chosen = withBlock(this.chosen, name, change);
    this.blocks.value = this.blocks.peek().map((block) => (block.name === name ? change(block) : block));
    this.change({ configuration: this.chosen });
  }

  /** Go back to the saved version. */
  discard(): void {
    UNSAVED.drop(this.saved.peek());
    this.restored.value = false;
    this.named = this.saved.peek() !== "";
    this.written.value = this.original.peek();
  }

  save(): void {
    // The name comes from the function, which the server is still reading.
    this.waiting = !this.named && !this.current.peek();
    if (this.waiting) return;
    const { name, source, configuration } = this.written.peek();
    if (!name.trim()) return this.refuse(t("page-custom-nameless"));
    const replaces = this.saved.peek();
    void this.ask({ kind: "SaveCustomBlock", name: name.trim(), source, configuration, replaces });
  }

  private async ask(message: SaveCustomBlock): Promise<void> {
    const saving = this.written.peek();
    const answer = await this.connection.ask(message);
    if (answer.kind === "Failed") return this.refuse(answer.message);
    if (answer.kind !== "CustomBlockChecked") return this.wasSaved(message.name, saving);
    // It has mistakes, which are shown in its source.
    this.refuse("");
    this.show(answer);
  }

  private begin(saved: string, original: Written): void {
    const left = UNSAVED.read(saved);
    this.named = saved !== "" || !!left?.name;
    batch(() => {
      this.saved.value = saved;
      this.original.value = original;
      this.restored.value = left !== null;
      this.written.value = left ?? original;
    });
    this.cleanup.add(effect(() => this.keepUnsaved()));
  }

  private check(code: string, written: Written, replaces: string): void {
    const { name, source, configuration } = written;
    const question = { name: name.trim(), source, configuration, replaces, language: code };
    if (!source) return;
    this.asking.do(async () => {
      const answer = await this.connection.ask({ kind: "CheckCustomBlock", ...question });
      // The text has changed since: another answer is coming.
      if (answer.kind !== "CustomBlockChecked" || written !== this.written.peek()) return;
      this.show(answer);
      if (this.waiting) this.save();
    });
  }

  private show(message: CustomBlockChecked): void {
    this.checked.value = message;
    if (message.configuration) this.preview(message);
    this.answered.value = this.written.peek();
  }

  private preview({ configuration = "", chosen = "", previews = [] }: CustomBlockChecked): void {
    this.chosen = chosen;
    this.blocks.value = blocksIn(configuration);
    this.previews.value = previews;
    this.followFunction();
  }

  /** A new block is named after its function. */
  private followFunction(): void {
    const [first] = this.blocks.peek();
    const written = this.written.peek();
    if (this.named || !first || first.name === written.name) return;
    const named = { ...written, name: first.name };
    batch(() => {
      if (!this.dirty.peek()) this.original.value = named;
      this.written.value = named;
    });
  }

  private wasSaved(name: string, saving: Written): void {
    UNSAVED.drop(this.saved.peek());
    UNSAVED.drop(name);
    const original = { ...saving, name };
    this.named = true;
    batch(() => {
      if (same(saving, this.written.peek())) this.written.value = original;
      this.saved.value = name;
      this.original.value = original;
      this.restored.value = false;
      this.outcome.value = { saved: name };
    });
  }

  private refuse(refused: Phrase | string): void {
    this.outcome.value = { refused };
  }

  private keepUnsaved(): void {
    const written = this.written.value;
    const saved = untracked(() => this.saved.value);
    if (this.dirty.value) UNSAVED.keep(saved, written);
    else UNSAVED.drop(saved);
  }
}

function same(one: Written, other: Written): boolean {
  return one.name === other.name && one.source === other.source && one.configuration === other.configuration;
}
