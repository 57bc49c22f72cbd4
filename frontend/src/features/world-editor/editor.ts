/** The island of the world editor: it connects the draft, its views and the server. */

import { computed, effect, signal } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { WorldToEdit } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { UnsavedEdits } from "../../ui/storage";
import type { Ref } from "../../views/world/plan/sorts";
import type { WorldValues } from "../../views/world/scenery/description";
import { type Action, WorldEditorActions } from "./actions";
import { Board } from "./board";
import type { Carried } from "./carrying";
import { Checking } from "./checking";
import { Commands, LARGER, TURN } from "./commands";
import { editorKeys } from "./keys";
import { isSameOffer, type Offer, wordOf } from "./offers";
import { ThingPalette } from "./palette";
import { createProperties } from "./properties";
import { hasPlace, Putting } from "./putting";
import { Saving } from "./saving";
import { Templates } from "./templates";
import { snapped } from "./things";
import { WorldEdit } from "./world-edit";

/** The content of a new world. */
const NEW = "empty";
/** By the name of the world that was opened. */
const UNSAVED = new UnsavedEdits<WorldValues>("learnblock.worlds");

export class WorldEditor implements Island {
  readonly dom = document.createElement("div");
  private readonly draft = new WorldEdit();
  /** The world as it was read or saved last. */
  private readonly opened = signal<{ readonly name: string; readonly world: WorldValues } | null>(null);
  private readonly commands = new Commands(this.draft);
  /** Whether positions are rounded to the grid. */
  private readonly snaps = signal(true);
  private readonly putting = new Putting();
  private readonly palette = new ThingPalette(
    this.draft,
    this.putting.offer,
    (offer) => this.choose(offer),
    (offer) => this.carry(offer),
  );
  private readonly properties = createProperties(this.draft, this.snaps);
  private readonly checking: Checking;
  private readonly board: Board;
  private readonly actions: WorldEditorActions;
  private readonly objectActions: WorldEditorActions;
  private readonly saving: Saving;
  private readonly templates: Templates;
  private readonly help = document.createElement("p");
  private readonly told = document.createElement("p");
  private readonly cleanup: Cleanup;

  constructor(
    private readonly context: Context,
    private readonly freeTitle: (name: string) => string,
    private readonly leave: (title: string) => void,
    first: string,
  ) {
    const { connection } = context;
    this.checking = new Checking(this.draft, connection);
    this.board = new Board(
      this.draft,
      () => this.snaps.peek(),
      this.putting,
      () => this.put(),
      this.checking.unreachable,
      context.running,
    );
    this.actions = new WorldEditorActions("page-editor-actions", this.worldActions());
    this.objectActions = new WorldEditorActions("page-editor-selected", this.thingActions());
    this.templates = new Templates({
      empty: () => this.read(NEW),
      make: (template, size, seed) => connection.send({ kind: "MakeWorld", template, size, seed }),
    });
    this.saving = new Saving(this.draft, connection, this.checking.problems, (name, title) => this.saved(name, title));
    this.build();
    this.cleanup = new Cleanup(
      connection.on("WorldToEdit", (message) => message.request || this.open(message)),
      connection.on("WorldMade", ({ world }) => this.made(world)),
      effect(() => this.keepUnsaved(this.draft.world.value)),
      effect(() => this.words()),
    );
    this.read(first || context.running.world.peek() || NEW);
  }

  destroy(): void {
    this.cleanup.dispose();
    for (const part of this.parts) part.destroy();
    this.dom.remove();
  }

  private get parts(): readonly { destroy(): void }[] {
    return [
      this.actions,
      this.objectActions,
      this.board,
      this.palette,
      this.properties,
      this.checking,
      this.saving,
      this.templates,
    ];
  }

  private build(): void {
    this.dom.className = "world-editor";
    this.help.className = "editor-help";
    this.told.className = "hidden";
    this.told.role = "status";
    const head = part("head", this.actions.dom, this.saving.dom);
    const middle = part("editor-middle", this.board.dom, this.checking.dom, this.help, this.told);
    const side = part("editor-side", this.objectActions.dom, this.properties.dom);
    this.dom.append(head, this.templates.dom, this.palette.dom, middle, side);
    this.dom.addEventListener("keydown", (event) => this.cancel(event));
    this.board.dom.addEventListener("pointerdown", () => this.templates.close());
    this.dom.addEventListener("keydown", editorKeys(this.draft, this.commands, this.board));
  }

  private words(): void {
    const offer = this.putting.offer.value;
    const named = offer && t(wordOf(offer));
    this.help.classList.toggle("puts", offer !== null);
    this.help.textContent = named ? t("page-editor-put", { sort: named }) : t("page-editor-help");
    const [x, y] = this.putting.place.value;
    this.told.textContent = named ? t("page-editor-at", { name: named, x: Math.round(x), y: Math.round(y) }) : "";
  }

  private worldActions(): Action[] {
    const { draft, board } = this;
    return [
      { name: "new", act: () => this.templates.toggle() },
      { name: "undo", enabled: draft.canUndo, act: () => draft.undo() },
      { name: "redo", enabled: draft.canRedo, act: () => draft.redo() },
      ...(board.hasRoom ? this.views() : []),
      { name: "nearer", act: () => board.zoom(0.75) },
      { name: "farther", act: () => board.zoom(1 / 0.75) },
      { name: "fit", act: () => board.fit() },
      { name: "share", enabled: computed(() => this.isSaved()), act: () => this.share() },
    ];
  }

  private views(): Action[] {
    const { board } = this;
    return [
      { name: "room", pressed: computed(() => board.isRoom), act: () => board.look("room") },
      { name: "plan", pressed: computed(() => !board.isRoom), act: () => board.look("plan") },
    ];
  }

  private thingActions(): Action[] {
    const enabled = computed(() => this.draft.selected.value !== null);
    return [
      { name: "left", enabled, act: () => this.commands.turn(-TURN) },
      { name: "right", enabled, act: () => this.commands.turn(TURN) },
      { name: "larger", enabled, act: () => this.commands.enlarge(LARGER) },
      { name: "smaller", enabled, act: () => this.commands.enlarge(1 / LARGER) },
      { name: "duplicate", enabled, act: () => this.show(this.commands.duplicate()) },
      { name: "delete", enabled, act: () => this.commands.remove() },
    ];
  }

  private read(name: string): void {
    this.context.connection.send({ kind: "ReadWorld", name });
  }

  private open({ name, world, save_as }: WorldToEdit): void {
    const left = UNSAVED.read(name);
    this.opened.value = { name, world };
    this.draft.open(world);
    if (save_as === name) this.saving.propose(world.title || name, name);
    else this.saving.propose(this.freeTitle(name));
    if (left) this.goOn(left);
    this.board.fit();
  }

  private saved(name: string, title: string): void {
    UNSAVED.drop(this.opened.peek()?.name ?? name);
    this.leave(title);
  }

  /** Continue an unsaved edit; undo goes back to the file's content. */
  private goOn(left: WorldValues): void {
    this.draft.change(left);
    this.saving.say("page-editor-goes-on");
  }

  private keepUnsaved(world: WorldValues | null): void {
    const opened = this.opened.peek();
    if (world && opened && world !== opened.world) UNSAVED.keep(opened.name, world);
  }

  /** A world from a template, in place of what was edited; undo brings that back. */
  private made(world: WorldValues): void {
    this.opened.value = { name: NEW, world };
    this.draft.change(world, "template", null);
    this.saving.propose(this.templates.title);
    this.board.fit();
  }

  private isSaved(): boolean {
    const opened = this.opened.value;
    return opened !== null && opened.name !== NEW && opened.world === this.draft.world.value;
  }

  private share(): void {
    const name = this.opened.peek()?.name;
    if (name) this.context.connection.send({ kind: "ExportWorld", name });
  }

  /** The next press on the board puts such an object there. */
  private choose(offer: Offer): void {
    if (!hasPlace(offer)) {
      this.show(this.commands.add(offer, [0, 0]));
      return;
    }
    if (isSameOffer(this.putting.offer.peek(), offer)) {
      this.putting.end();
      return;
    }
    const [x, y] = this.board.centre;
    this.putting.begin(offer, [snapped(x), snapped(y)]);
    this.board.focusCross();
  }

  private carry(offer: Offer): Carried {
    return {
      move: (event) => this.putting.begin(offer, this.board.placeAt(event)),
      drop: (event) => {
        if (!this.board.isOver(event)) this.putting.end();
        else if (!hasPlace(offer)) this.choose(offer);
        else this.show(this.put());
      },
      cancel: () => this.putting.end(),
    };
  }

  private put(): Ref | null {
    const given = this.putting.end();
    return given && this.commands.add(given.offer, given.place);
  }

  /** Escape ends what has begun before it closes the editor. */
  private cancel(event: KeyboardEvent): void {
    if (event.key !== "Escape") return;
    const offer = this.putting.end()?.offer;
    if (offer) this.palette.focus(offer);
    else if (!this.templates.close()) return;
    event.preventDefault();
    event.stopPropagation();
  }

  private show(ref: Ref | null): void {
    if (ref) this.board.focus(ref);
  }
}

function part(name: string, ...children: Element[]): HTMLElement {
  const element = document.createElement("div");
  element.className = name;
  element.append(...children);
  return element;
}
