/** The buttons over the world. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { t } from "../../i18n";
import type { Island } from "../../ui/island";
import { type IconName, icon } from "./icons";

/** A button; one with `pressed` can be switched on and off. */
export interface Tool {
  readonly name: IconName;
  /** The key that does the same while the world has the focus. */
  readonly key: string;
  readonly pressed?: ReadonlySignal<boolean>;
  readonly enabled?: ReadonlySignal<boolean>;
  act(): void;
}

export class Toolbar implements Island {
  readonly dom = document.createElement("div");
  private readonly endings: (() => void)[] = [];

  constructor(tools: readonly Tool[]) {
    this.dom.className = "world-toolbar";
    this.dom.role = "group";
    this.endings.push(
      effect(() => {
        this.dom.ariaLabel = t("page-world-toolbar");
      }),
    );
    for (const tool of tools) this.dom.append(this.button(tool));
  }

  destroy(): void {
    for (const end of this.endings) end();
    this.dom.remove();
  }

  private button({ name, key, pressed, enabled, act }: Tool): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.tool = name;
    button.append(icon(name));
    button.addEventListener("click", act);
    this.endings.push(
      effect(() => {
        button.ariaLabel = t(`page-world-tool-${name}`);
        button.title = t("page-world-tool-key", { tool: t(`page-world-tool-${name}`), key: key.toUpperCase() });
        if (pressed) button.ariaPressed = String(pressed.value);
        button.disabled = enabled ? !enabled.value : false;
      }),
    );
    return button;
  }
}
