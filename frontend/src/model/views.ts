/** Which regions of the page are shown, including the three views of the program. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Problem, View, Workspace } from "../protocol/messages";
import type { Island } from "../ui/island";
import { room } from "../ui/screen";
import type { Tool } from "../ui/tool";
import type { Measure } from "./measures";
import type { MissedPlace } from "./missed";
import type { OwnBlock } from "./own-blocks";
import { arrange, preferences } from "./preferences";

export const VIEWS: readonly View[] = ["blocks", "blocktext", "python"];
export type Area = View | "world" | "panel";
export type PanelName = "console" | "variables" | "calls" | "why" | "runs" | "sensors" | "problems" | "result";

/** A choice of the robots that the picture follows: all, two side by side, or one. */
export interface PlayerView {
  readonly kind: "all" | "split" | "one";
  readonly text: string;
  readonly on: boolean;
  choose(): void;
}

/** The world in 3D. */
export interface WorldIsland extends Island {
  /** Adapt to the current size of the element. */
  resize(): void;
  /** Draw at the best quality now, for a picture that is kept. */
  drawBest(): void;
  /** The number of frames drawn, for benchmarks. */
  readonly framesDrawn: number;
  /** What the user can do in the world, for menus and keys; empty if the browser cannot draw in 3D. */
  readonly tools: readonly Tool[];
  /** Which of several robots it can follow; empty in a world with one robot. */
  readonly playerViews: ReadonlySignal<readonly PlayerView[]>;
  /** What keys do in the world now, in words; empty if there is nothing to say. */
  readonly hint: ReadonlySignal<string>;
  /** Show in the picture where a value of the robot comes from; null shows none. */
  point(measure: Measure | null): void;
  /** Mark the places that the last run has missed. */
  showMissed(places: readonly MissedPlace[]): void;
  /** Go round the robots with the camera, or show again what the user has chosen. */
  circle(on: boolean): void;
  /** Look at a place on the floor, mm. */
  lookAt(place: readonly [number, number]): void;
}

/** A change of the size of the blocks: one step, or back to the usual one. */
export type Zoom = "in" | "out" | "reset";

/** A view of the program. */
export interface ViewIsland extends Island {
  focus(): void;
  reveal(block: string): void;
  /** A statement as this view shows it, in one line; empty if it does not know the statement. */
  describeStep(block: string): string;
  zoom?(change: Zoom): void;
  ownBlock?(definition: string): OwnBlock | null;
  change?(change: (program: Workspace) => Workspace): void;
  enter?(block: string): void;
  /** Show help on what has the focus in it; return whether there is any. */
  explain?(): boolean;
  /** Obey a key that was pressed outside of it; return whether it did. */
  press?(event: KeyboardEvent): boolean;
  /** Both from 1; column 0 is the line's first word. */
  goTo?(line: number, column: number): void;
}

export class Views {
  /** What a phone shows below the world. */
  readonly area = signal<View | "panel">(preferences.value.layout.view);
  readonly panel = signal<PanelName>("console");
  /** The world once it has loaded. */
  readonly world = signal<WorldIsland | null>(null);
  /** What the user wants to have plotted, until the plot shows it. */
  readonly plotted = signal<Measure | null>(null);
  /** The statement that the user has selected in a view, by its block. */
  readonly selected = signal<string | null>(null);
  private readonly loaded = signal<ReadonlyMap<View, ViewIsland>>(new Map());
  /** Whether the world and all views of the program that are shown have loaded. */
  readonly areLoaded = computed(
    () => this.world.value !== null && VIEWS.every((view) => !this.shows(view) || this.loaded.value.has(view)),
  );

  private get islands(): ReadonlyMap<View, ViewIsland> {
    return this.loaded.peek();
  }

  /** Register a view, or remove it with null. */
  put(view: View, island: ViewIsland | null): void {
    const loaded = new Map(this.islands);
    if (island) loaded.set(view, island);
    else loaded.delete(view);
    this.loaded.value = loaded;
  }

  /** Whether several views of the program are side by side. */
  get isSplit(): boolean {
    return room.value !== "narrow" && preferences.value.layout.split;
  }

  /** Whether a part of the panel can be seen. */
  showsPanel(name: PanelName): boolean {
    return this.shows("panel") && this.panel.value === name;
  }

  shows(area: Area): boolean {
    if (area === "world") return true;
    if (room.value === "narrow") return area === this.area.value;
    const { views, view, panel } = preferences.value.layout;
    if (area === "panel") return panel;
    return this.isSplit ? views.includes(area) : area === view;
  }

  /** A view of the program that is open, the one that was `edited` last if possible. */
  programView(edited: View): View {
    return this.shows(edited) ? edited : preferences.value.layout.view;
  }

  show(area: Area): void {
    if (area === "world") return;
    this.area.value = area;
    if (area === "panel") return arrange({ panel: true });
    const { views } = preferences.value.layout;
    const shown = VIEWS.filter((one) => one === area || views.includes(one));
    arrange({ view: area, views: shown });
  }

  /** Show a view alone; of views side by side, show or hide it, but keep the last one. */
  toggle(view: View): void {
    const { views } = preferences.value.layout;
    if (!this.isSplit || !views.includes(view)) return this.show(view);
    const others = views.filter((one) => one !== view);
    if (others[0]) arrange({ views: others, view: others[0] });
  }

  /** Show several views side by side, or only one. */
  toggleSplit(): void {
    const { split, view, views } = preferences.value.layout;
    if (split) return arrange({ split: false, view: views.includes(view) ? view : (views[0] ?? view) });
    const shown = VIEWS.filter((one) => one === view || views.includes(one));
    const beside = view === "blocks" ? "blocktext" : "blocks";
    arrange({ split: true, views: shown.length > 1 ? shown : VIEWS.filter((one) => one === view || one === beside) });
  }

  togglePanel(): void {
    if (!this.shows("panel")) return this.show("panel");
    this.area.value = preferences.value.layout.view;
    arrange({ panel: false });
  }

  showPanel(panel: PanelName): void {
    this.panel.value = panel;
    this.show("panel");
  }

  /** Plot a value of the robot. */
  plot(measure: Measure): void {
    this.plotted.value = measure;
    this.showPanel("sensors");
  }

  /** A statement as a view shows it, in one line. */
  describeStep(view: View, block: string): string {
    return this.islands.get(view)?.describeStep(block) ?? "";
  }

  /** Show help on what has the focus in a view; return whether there is any. */
  explain(): boolean {
    return [...this.islands.values()].some((island) => island.explain?.());
  }

  /** A block that the program defines, as the blocks have it, by its definition. */
  ownBlock(definition: string): OwnBlock | null {
    return this.islands.get("blocks")?.ownBlock?.(definition) ?? null;
  }

  /** Change the program in its blocks, as one edit by the user. */
  changeBlocks(change: (program: Workspace) => Workspace): void {
    this.islands.get("blocks")?.change?.(change);
  }

  /** Move the focus to a block, in sight. */
  enterBlock(block: string): void {
    this.islands.get("blocks")?.enter?.(block);
  }

  /** Obey a key of the blocks that was pressed elsewhere; return whether they did. */
  pressInBlocks(event: KeyboardEvent): boolean {
    return this.islands.get("blocks")?.press?.(event) ?? false;
  }

  zoomBlocks(change: Zoom): void {
    this.islands.get("blocks")?.zoom?.(change);
  }

  focus(view: View): void {
    this.islands.get(view)?.focus();
  }

  /** Show a statement in all visible views. */
  reveal(block: string): void {
    for (const view of VIEWS) if (this.shows(view)) this.islands.get(view)?.reveal(block);
  }

  /** Go to a problem, with the focus in the problem's view. */
  goTo(problem: Problem): void {
    this.show(problem.view);
    if (problem.block) this.reveal(problem.block);
    // A view that was hidden has no size until the next frame.
    requestAnimationFrame(() => this.enter(problem));
  }

  private enter({ view, line = 0, column = 0, block }: Problem): void {
    const island = this.islands.get(view);
    if (block) island?.reveal(block);
    if (line > 0) island?.goTo?.(line, column);
    island?.focus();
  }
}
