/** Blocks that are copied in one tab of the browser can be pasted in its other tabs. */

import * as Blockly from "blockly/core";

import { inBrowser } from "../../ui/storage";

const STORED = inBrowser("learnblock-copied");
const { clipboard } = Blockly;

/** Shares the clipboard of a workspace. */
export class SharedClipboard {
  private kept: string | null = null;

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    // Another tab can only paste after this window has lost the focus, or this tab is hidden.
    window.addEventListener("blur", this.keep);
    document.addEventListener("visibilitychange", this.keep);
    window.addEventListener("focus", this.take);
    window.addEventListener("storage", this.take);
    this.take();
  }

  destroy(): void {
    window.removeEventListener("blur", this.keep);
    document.removeEventListener("visibilitychange", this.keep);
    window.removeEventListener("focus", this.take);
    window.removeEventListener("storage", this.take);
  }

  private readonly keep = (): void => {
    const copied = clipboard.getLastCopiedData();
    const text = copied && JSON.stringify(copied);
    if (!text || text === this.kept) return;
    this.kept = text;
    STORED.write(text);
  };

  private readonly take = (): void => {
    const copied = this.read();
    if (!copied) return;
    clipboard.setLastCopiedData(copied);
    clipboard.setLastCopiedWorkspace(this.workspace);
  };

  /** What another tab has copied since; null if it can't be read. */
  private read(): Blockly.ICopyData | null {
    try {
      const text = STORED.read();
      if (!text || text === this.kept) return null;
      this.kept = text;
      return JSON.parse(text) as Blockly.ICopyData;
    } catch {
      return null;
    }
  }
}
