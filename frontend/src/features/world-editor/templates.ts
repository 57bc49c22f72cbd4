/** The panel that begins a new world: an empty one, or one from a template with a size and a seed. */

import { effect } from "@preact/signals";

import { t } from "../../i18n";
import type { MakeWorld } from "../../protocol/messages";
import type { Island } from "../../ui/island";

type Template = MakeWorld["template"];

/** What the buttons of the panel do. */
interface Makes {
  empty(): void;
  make(template: Template, size: number, seed: number): void;
}

const TEMPLATES: readonly Template[] = ["field", "track", "maze"];
/** The server's limits. */
const SIZES = { least: 3, most: 8, usual: 5 } as const;
const LARGEST_SEED = 999_999;
/** Seeds that the page draws are short enough to say aloud. */
const SHORT_SEEDS = 1000;

export class Templates implements Island {
  readonly dom = document.createElement("form");
  private readonly legend = document.createElement("strong");
  private readonly buttons = new Map<Template | "empty", HTMLButtonElement>();
  private readonly size = document.createElement("input");
  private readonly seed = document.createElement("input");
  private readonly another = document.createElement("button");
  private readonly done = document.createElement("button");
  private chosen: Template | null = null;
  private readonly ending: () => void;

  constructor(private readonly makes: Makes) {
    this.build();
    this.ending = effect(() => this.words());
  }

  /** The title of the world that was made last. */
  get title(): string {
    return `${t(`page-editor-template-${this.chosen ?? "field"}`)} ${this.seed.value}`;
  }

  toggle(): void {
    this.dom.hidden = !this.dom.hidden;
    if (!this.dom.hidden) this.buttons.get("empty")?.focus();
  }

  /** Close it; return whether it was open. */
  close(): boolean {
    const wasOpen = !this.dom.hidden;
    this.dom.hidden = true;
    return wasOpen;
  }

  destroy(): void {
    this.ending();
    this.dom.remove();
  }

  private build(): void {
    this.dom.className = "editor-templates";
    this.dom.hidden = true;
    for (const name of ["empty", ...TEMPLATES] as const) this.buttons.set(name, this.button(name));
    Object.assign(this.size, { type: "range", min: SIZES.least, max: SIZES.most, value: SIZES.usual });
    Object.assign(this.seed, { type: "number", min: 0, max: LARGEST_SEED, step: 1, required: true });
    this.draw();
    this.another.type = "button";
    this.another.addEventListener("click", () => {
      this.draw();
      this.make();
    });
    for (const input of [this.size, this.seed]) input.addEventListener("input", () => this.make());
    const kinds = document.createElement("div");
    kinds.append(...this.buttons.values());
    this.dom.append(this.legend, kinds, labelled(this.size), labelled(this.seed), this.another, this.done);
    this.done.className = "primary";
    this.dom.addEventListener("submit", (event) => {
      event.preventDefault();
      this.close();
    });
  }

  private button(name: Template | "empty"): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.template = name;
    button.addEventListener("click", () => this.choose(name));
    return button;
  }

  private choose(name: Template | "empty"): void {
    this.chosen = name === "empty" ? null : name;
    this.show();
    if (this.chosen) this.make();
    else {
      this.close();
      this.makes.empty();
    }
  }

  private draw(): void {
    this.seed.value = String(1 + Math.floor(Math.random() * (SHORT_SEEDS - 1)));
  }

  private make(): void {
    if (this.chosen && this.dom.checkValidity())
      this.makes.make(this.chosen, Number(this.size.value), Number(this.seed.value));
  }

  /** Size and seed are for templates only. */
  private show(): void {
    for (const [name, button] of this.buttons) button.ariaPressed = String(name === this.chosen);
    for (const input of [this.size, this.seed, this.another]) input.disabled = this.chosen === null;
  }

  private words(): void {
    this.legend.textContent = t("page-editor-action-new");
    this.dom.ariaLabel = t("page-editor-action-new");
    for (const [name, button] of this.buttons) button.textContent = t(`page-editor-template-${name}`);
    this.done.textContent = t("page-editor-template-done");
    this.another.textContent = t("page-editor-template-another");
    name(this.size, t("page-editor-template-size"));
    name(this.seed, t("page-editor-template-seed"));
    this.seed.title = t("page-editor-template-seed-help");
    this.show();
  }
}

function labelled(input: HTMLInputElement): HTMLLabelElement {
  const label = document.createElement("label");
  label.append(document.createElement("span"), input);
  return label;
}

function name(input: HTMLInputElement, words: string): void {
  const label = input.previousElementSibling;
  if (label) label.textContent = words;
}
