/** A block that is being edited: what is written, what the server says of it, and saving it. */

import { batch, computed, effect, signal, untracked } from "@preact/signals";

import type { Connection } from "../connection";
import { language, t } from "../i18n";
import type { OwnBlock, OwnBlockChecked, OwnBlockPreview, OwnBlockProblem } from "../messages";
import { Throttle } from "../world/throttle";
import { blocksIn, type Configured, withBlock } from "./configuration";
import { drop, keep, unsaved, type Written } from "./unsaved";

/** ms between two questions. */
const PERIOD = 300;

export class Draft {
  readonly written = signal<Written>({ name: "", source: "", configuration: "" });
  /** The name that it is saved under; empty while it never was. */
  readonly saved = signal("");
  readonly checked = signal<OwnBlockChecked | null>(null);
  /** Whether it goes on from what was left without being saved. */
  readonly goesOn = signal(false);
  /** What became of saving it: a name, or why not. */
  readonly outcome = signal<{ readonly saved: string } | { readonly refused: string } | null>(null);

  readonly problems = computed<readonly OwnBlockProblem[]>(() => this.checked.value?.problems ?? []);
  /** Of the last source that could be read. */
  readonly blocks = signal<readonly Configured[]>([]);
  readonly previews = signal<readonly OwnBlockPreview[]>([]);
  /** As JSON: what was written, or else what the server makes of the source. */
  readonly configuration = computed(() => this.written.value.configuration || (this.checked.value?.configuration ?? ""));
  /** Whether what the server said is about what is written now. */
  readonly current = computed(() => this.answered.value === this.written.value);
  readonly dirty = computed(() => !same(this.written.value, this.original.value));

  private readonly original = signal<Written>(this.written.peek());
  private readonly asking = new Throttle(PERIOD);
  private request = 0;
  /** What the last question was about: an answer is of use only while it is what is written. */
  private asked: Written | null = null;
  /** The configuration without what the source says by itself: what is chosen in the form goes into it. */
  private chosen = "";
  private readonly answered = signal<Written | null>(null);
  /** Whether it is to be saved as soon as the server has answered. */
  private waiting = false;
  private saving: Written | null = null;
  /** Whether the name follows the function's: until somebody writes one. */
  private named = false;
  private readonly ends: (() => void)[];

  constructor(private readonly connection: Connection) {
    this.ends = [
      connection.on("OwnBlockChecked", (message) => this.hear(message)),
      connection.on("OwnBlockSaved", ({ name }) => this.hearSaved(name)),
      connection.onRefused(["SaveOwnBlock"], (reason) => this.refused(reason)),
      effect(() => this.ask(language.value, this.written.value, this.saved.value)),
    ];
  }

  destroy(): void {
    for (const end of this.ends) end();
    this.asking.cancel();
  }

  /** Edit a block that is saved. */
  open({ name, source, configuration }: OwnBlock): void {
    this.begin(name, { name, source, configuration });
  }

  /** Edit a new one. */
  create(source: string): void {
    this.begin("", { name: "", source, configuration: "" });
  }

  change(change: Partial<Written>): void {
    if (change.name !== undefined) this.named = true;
    this.written.value = { ...this.written.value, ...change };
    this.outcome.value = null;
  }

  /** Change what is chosen for one of its functions. */
  configure(name: string, change: (block: Configured) => Configured): void {
    this.chosen = withBlock(this.chosen, name, change);
    this.blocks.value = this.blocks.peek().map((block) => (block.name === name ? change(block) : block));
    this.change({ configuration: this.chosen });
  }

  /** Go back to what is saved. */
  discard(): void {
    drop(this.saved.peek());
    this.goesOn.value = false;
    this.named = this.saved.peek() !== "";
    this.written.value = this.original.peek();
  }

  save(): void {
    // Its name is that of its function, which the server is still reading.
    this.waiting = !this.named && !this.current.peek();
    if (this.waiting) return;
    const { name, source, configuration } = this.written.peek();
    if (!name.trim()) return this.refuse(t("ownblocks.nameless"));
    this.saving = this.written.peek();
    const replaces = this.saved.peek();
    if (!this.connection.send({ kind: "SaveOwnBlock", name: name.trim(), source, configuration, replaces })) this.refused(t("chrome.lost"));
  }

  private begin(saved: string, original: Written): void {
    const left = unsaved(saved);
    this.named = saved !== "" || !!left?.name;
    batch(() => {
      this.saved.value = saved;
      this.original.value = original;
      this.goesOn.value = left !== null;
      this.written.value = left ?? original;
    });
    this.ends.push(effect(() => this.keepUnsaved()));
  }

  private ask(code: string, written: Written, replaces: string): void {
    const { name, source, configuration } = written;
    const question = { name: name.trim(), source, configuration, replaces, language: code };
    if (!source) return;
    this.asking.do(() => {
      this.request += 1;
      this.asked = written;
      this.connection.send({ kind: "CheckOwnBlock", request: this.request, ...question });
    });
  }

  private hear(message: OwnBlockChecked): void {
    if (message.request === 0) this.refused("");
    else if (message.request !== this.request || this.asked !== this.written.peek()) return;
    this.checked.value = message;
    const { configuration = "" } = message;
    if (configuration) this.show(message);
    this.answered.value = this.written.peek();
    if (this.waiting) this.save();
  }

  private show({ configuration = "", chosen = "", previews = [] }: OwnBlockChecked): void {
    this.chosen = chosen;
    this.blocks.value = blocksIn(configuration);
    this.previews.value = previews;
    this.followFunction();
  }

  /** A new block is called what its function is called. */
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

  private hearSaved(name: string): void {
    const { saving } = this;
    if (!saving) return;
    this.saving = null;
    drop(this.saved.peek());
    drop(name);
    const original = { ...saving, name };
    this.named = true;
    batch(() => {
      if (same(saving, this.written.peek())) this.written.value = original;
      this.saved.value = name;
      this.original.value = original;
      this.goesOn.value = false;
      this.outcome.value = { saved: name };
    });
  }

  private refused(reason: string): void {
    if (!this.saving) return;
    this.saving = null;
    this.refuse(reason);
  }

  private refuse(refused: string): void {
    this.outcome.value = { refused };
  }

  private keepUnsaved(): void {
    const written = this.written.value;
    const saved = untracked(() => this.saved.value);
    if (this.dirty.value) keep(saved, written);
    else drop(saved);
  }
}

function same(one: Written, other: Written): boolean {
  return one.name === other.name && one.source === other.source && one.configuration === other.configuration;
}
