/** The island of the world editor: it connects the draft, its views and the server. */

import { computed, effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { WorldToEdit } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import type { WorldValues } from "../../views/world/scenery/description";
import { type Action, Actions } from "./actions";
import { Checking } from "./checking";
import { Commands, TURN } from "./commands";
import { Draft } from "./drafts";
import { editorKeys } from "./keys";
import { Palette } from "./palette";
import { Plan } from "./plan";
import { Properties } from "./properties";
import { Saving } from "./saving";
import type { Sort } from "./sorts";
import type { Ref } from "./things";
import { drop, keep, unsaved } from "./unsaved";

/** The content of a new world. */
const NEW = "empty";

export class Editor implements Island {
  readonly dom = document.createElement("div");
  private readonly draft = new Draft();
  private readonly commands = new Commands(this.draft);
  private readonly actions = new Actions(this.offered());
  private readonly plan = new Plan(this.draft, () => this.actions.snaps.peek());
  private readonly palette = new Palette(this.draft, (sort) => this.add(sort));
  private readonly properties = new Properties(this.draft);
  private readonly checking: Checking;
  private readonly saving: Saving;
  private readonly closing = document.createElement("button");
  private readonly help = document.createElement("p");
  private opened: { readonly name: string; readonly world: WorldValues } | null = null;
  private readonly endings: (() => void)[];

  constructor(
    private readonly context: Context,
    onClose: () => void,
    private readonly freeTitle: (name: string) => string,
  ) {
    const { connection } = context;
    this.checking = new Checking(this.draft, connection);
    this.saving = new Saving(this.draft, connection, this.checking.problems, (name) => this.saved(name));
    this.closing.addEventListener("click", onClose);
    this.build();
    this.endings = [
      connection.on("WorldToEdit", (message) => this.open(message)),
      effect(() => this.keepUnsaved(this.draft.world.value)),
      effect(() => this.words()),
    ];
    this.read(context.running.world.peek() || NEW);
  }

  destroy(): void {
    for (const end of this.endings) end();
    for (const part of [this.actions, this.plan, this.palette, this.properties, this.checking, this.saving])
      part.destroy();
    this.dom.remove();
  }

  private build(): void {
    this.dom.className = "world-editor";
    this.closing.type = "button";
    this.help.className = "editor-help";
    const head = part("div", this.actions.dom, this.saving.dom, this.closing);
    head.className = "head";
    const middle = part("div", this.plan.dom, this.help);
    middle.className = "editor-middle";
    const side = part("aside", this.properties.dom, this.checking.dom);
    this.dom.append(head, this.palette.dom, middle, side);
    this.dom.addEventListener("keydown", editorKeys(this.draft, this.commands, this.plan));
  }

  private words(): void {
    this.closing.textContent = t("page-editor-close");
    this.help.textContent = t("page-editor-help");
  }

  private offered(): Action[] {
    const { draft } = this;
    const selected = computed(() => draft.selected.value !== null);
    return [
      { name: "new", act: () => this.read(NEW) },
      { name: "undo", enabled: draft.canUndo, act: () => draft.undo() },
      { name: "redo", enabled: draft.canRedo, act: () => draft.redo() },
      { name: "duplicate", enabled: selected, act: () => this.show(this.commands.duplicate()) },
      { name: "left", enabled: selected, act: () => this.commands.turn(-TURN) },
      { name: "right", enabled: selected, act: () => this.commands.turn(TURN) },
      { name: "delete", enabled: selected, act: () => this.commands.remove() },
      { name: "nearer", act: () => this.plan.viewport.zoom(0.75) },
      { name: "farther", act: () => this.plan.viewport.zoom(1 / 0.75) },
      { name: "fit", act: () => this.plan.fit() },
    ];
  }

  private read(name: string): void {
    this.context.connection.send({ kind: "ReadWorld", name });
  }

  private open({ name, world, save_as }: WorldToEdit): void {
    const values = world as unknown as WorldValues;
    const left = unsaved(name);
    this.opened = { name, world: values };
    this.draft.open(values);
    if (save_as === name) this.saving.propose(values.title || name, name);
    else this.saving.propose(this.freeTitle(name));
    if (left) this.goOn(left);
    this.plan.fit();
  }

  /** Continue with the saved world. */
  private saved(name: string): void {
    const world = this.draft.world.peek();
    if (world) this.opened = { name, world };
    drop();
  }

  /** Continue an unsaved edit; undo goes back to the file's content. */
  private goOn(left: WorldValues): void {
    this.draft.change(left);
    this.saving.say("page-editor-goes-on");
  }

  private keepUnsaved(world: WorldValues | null): void {
    if (world && this.opened && world !== this.opened.world) keep(this.opened.name, world);
  }

  private add(sort: Sort): void {
    this.show(this.commands.add(sort, this.plan.viewport.centre));
  }

  private show(ref: Ref | null): void {
    if (ref) this.plan.focus(ref);
  }
}

function part(name: "div" | "aside", ...children: Element[]): HTMLElement {
  const element = document.createElement(name);
  element.append(...children);
  return element;
}
