/** The buttons over the plan. */

import { effect, type ReadonlySignal, signal } from "@preact/signals";
import { t } from "../../i18n";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { svg } from "../../views/world/plan/svg";

const PICTURES = {
  new: "M7 3h7l4 4v14H7zM14 3v4h4M12.500 11v6M9.500 14h6",
  undo: "M9 6 4 11l5 5M4 11h10a5 5 0 0 1 0 10h-3",
  redo: "M15 6l5 5-5 5M20 11H10a5 5 0 0 0 0 10h3",
  duplicate: "M8 8h12v12H8zM16 8V4H4v12h4",
  left: "M5 5v6h6M5.500 11a7.500 7.500 0 1 1 .5 6",
  right: "M19 5v6h-6M18.500 11a7.500 7.500 0 1 0-.5 6",
  delete: "M5 7h14M9 7V4h6v3M7 7l1 13h8l1-13M10.500 11v5M13.500 11v5",
  nearer: "M10.500 4a6.500 6.500 0 1 0 0 13 6.500 6.500 0 0 0 0-13M15.500 15.500 21 21M10.500 7.500v6M7.500 10.500h6",
  farther: "M10.500 4a6.500 6.500 0 1 0 0 13 6.500 6.500 0 0 0 0-13M15.500 15.500 21 21M7.500 10.500h6",
  share: "M12 4v11M7.500 10.500 12 15l4.500-4.500M5 19h14",
  fit: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
} as const;

export interface Action {
  readonly name: keyof typeof PICTURES;
  readonly enabled?: ReadonlySignal<boolean>;
  act(): void;
}

export class WorldEditorActions implements Island {
  readonly dom = document.createElement("div");
  /** Whether positions are rounded to the grid. */
  readonly snaps = signal(true);
  private readonly cleanup = new Cleanup();

  constructor(actions: readonly Action[]) {
    this.dom.className = "editor-actions";
    this.dom.role = "group";
    this.cleanup.add(
      effect(() => {
        this.dom.ariaLabel = t("page-editor-actions");
      }),
    );
    this.dom.append(...actions.map((action) => this.button(action)), this.snapping());
  }

  destroy(): void {
    this.cleanup.dispose();
    this.dom.remove();
  }

  private button({ name, enabled, act }: Action): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.action = name;
    button.append(svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: PICTURES[name] })));
    button.addEventListener("click", act);
    this.cleanup.add(
      effect(() => {
        button.ariaLabel = button.title = t(`page-editor-action-${name}`);
        button.disabled = enabled ? !enabled.value : false;
      }),
    );
    return button;
  }

  private snapping(): HTMLLabelElement {
    const label = document.createElement("label");
    const box = document.createElement("input");
    const words = document.createElement("span");
    box.type = "checkbox";
    box.checked = this.snaps.peek();
    box.addEventListener("change", () => (this.snaps.value = box.checked));
    label.append(box, words);
    this.cleanup.add(
      effect(() => {
        words.textContent = t("page-editor-snap");
      }),
    );
    return label;
  }
}
