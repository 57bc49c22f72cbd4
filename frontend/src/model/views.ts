/** Which regions of the page are shown, including the three views of the program. */

import { signal } from "@preact/signals";
import type { Problem, View } from "../protocol/messages";
import type { Island } from "../ui/island";
import { room } from "../ui/screen";
import { arrange, preferences } from "./preferences";

export const VIEWS: readonly View[] = ["blocks", "blocktext", "python"];
export type Area = View | "world" | "panel";
export type PanelName = "console" | "variables" | "sensors" | "problems" | "result";

/** A view of the program. */
export interface ViewIsland extends Island {
  focus(): void;
  reveal(block: string): void;
  /** Both from 1; column 0 is the line's first word. */
  goTo?(line: number, column: number): void;
}

export class Views {
  /** The region shown on a narrow screen. */
  readonly area = signal<Area>(preferences.value.layout.view);
  readonly panel = signal<PanelName>("console");
  /** The world once it has loaded; benchmarks count its frames. */
  world: Island | null = null;
  private readonly islands = new Map<View, ViewIsland>();

  /** Register a view, or remove it with null. */
  put(view: View, island: ViewIsland | null): void {
    if (island) this.islands.set(view, island);
    else this.islands.delete(view);
  }

  shows(area: Area): boolean {
    if (room.value === "narrow") return area === this.area.value;
    if (area === "world" || area === "panel") return true;
    const { views, view } = preferences.value.layout;
    return room.value === "medium" ? area === view : views.includes(area);
  }

  show(area: Area): void {
    this.area.value = area;
    if (area === "world" || area === "panel") return;
    const { views } = preferences.value.layout;
    const shown = VIEWS.filter((one) => one === area || views.includes(one));
    arrange({ view: area, views: shown });
  }

  /** Show or hide a view on a wide screen; the last one stays. */
  toggle(area: Area): void {
    const { views } = preferences.value.layout;
    if (room.value !== "wide" || !views.some((one) => one === area)) return this.show(area);
    if (views.length > 1) arrange({ views: views.filter((one) => one !== area) });
  }

  showPanel(panel: PanelName): void {
    this.panel.value = panel;
    this.show("panel");
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
