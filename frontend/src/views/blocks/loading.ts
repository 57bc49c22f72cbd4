/** Adds the blocks of a large program piece by piece, while those that are there can be used. */

import type * as Blockly from "blockly/core";
import { t } from "../../i18n";

// Why: docs/decisions.md, "Blocks of a long program load in slices"
export class Loading {
  private readonly note = document.createElement("p");
  private timer: ReturnType<typeof setTimeout> | 0 = 0;
  private waiting: (() => void)[] = [];

  /** `addNext` adds some blocks and returns whether there are more. */
  constructor(
    private readonly host: HTMLElement,
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly addNext: () => boolean,
  ) {
    this.note.className = "blocks-loading";
    this.note.setAttribute("role", "status");
  }

  destroy(): void {
    clearTimeout(this.timer);
    this.note.remove();
  }

  get isOn(): boolean {
    return this.timer !== 0;
  }

  begin(): void {
    if (this.isOn) return;
    this.note.textContent = t("page-blocks-loading");
    this.host.append(this.note);
    this.addSoon();
  }

  /** Call a function when the blocks are complete. */
  whenDone(act: () => void): void {
    this.waiting.push(act);
  }

  // A timer, not a frame: a page in the background gets none.
  private addSoon(): void {
    this.timer = setTimeout(() => {
      if (this.workspace.isDragging() || this.addNext()) this.addSoon();
      else this.end();
    });
  }

  private end(): void {
    this.timer = 0;
    this.note.remove();
    const { waiting } = this;
    this.waiting = [];
    for (const act of waiting) act();
  }
}
