/** The buttons over the plan. */

import { effect, type ReadonlySignal } from "@preact/signals";
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
  larger: "M4 20h16V4H4zM12 8v8M8 12h8",
  smaller: "M4 20h16V4H4zM8 12h8",
  room: "M12 3l8 4.500v9L12 21l-8-4.500v-9zM4 7.500l8 4.500 8-4.500M12 12v9",
  plan: "M4 6l5-2 6 2 5-2v14l-5 2-6-2-5 2zM9 4v14M15 6v14",
  share: "M12 4v11M7.500 10.500 12 15l4.500-4.500M5 19h14",
  fit: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
} as const;

export interface Action {
  readonly name: keyof typeof PICTURES;
  readonly enabled?: ReadonlySignal<boolean>;
  /** For a switch, whether it is on. */
  readonly pressed?: ReadonlySignal<boolean>;
  act(): void;
}

export class WorldEditorActions implements Island {
  readonly dom = document.createElement("div");
  private readonly cleanup = new Cleanup();

  /** @param word the code of the group's name. */
  constructor(word: string, actions: readonly Action[]) {
    this.dom.className = "editor-actions";
    this.dom.role = "group";
    this.cleanup.add(
      effect(() => {
        this.dom.ariaLabel = t(word);
      }),
    );
    this.dom.append(...actions.map((action) => this.button(action)));
  }

  destroy(): void {
    this.cleanup.dispose();
    this.dom.remove();
  }

  private button({ name, enabled, pressed, act }: Action): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.action = name;
    button.append(svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: PICTURES[name] })));
    const label = document.createElement("span");
    if (pressed) button.append(label);
    button.addEventListener("click", act);
    this.cleanup.add(
      effect(() => {
        const words = t(`page-editor-action-${name}`);
        button.disabled = enabled ? !enabled.value : false;
        if (!pressed) button.ariaLabel = button.title = words;
        else {
          // Its words are beside its picture.
          button.ariaPressed = String(pressed.value);
          label.textContent = words;
        }
      }),
    );
    return button;
  }
}
