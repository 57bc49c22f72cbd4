/** The invitation on an empty program: what to do first. */

import { effect } from "@preact/signals";
import type * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { icon } from "../../ui/icons";
import { media } from "../../ui/media";

/** A tablet has no keys to press. */
const byFinger = media("(pointer: coarse)");

export class Invitation {
  private readonly dom = document.createElement("p");
  private readonly words = document.createElement("span");
  private readonly stop: () => void;

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    this.dom.className = "lbInvitation";
    this.dom.hidden = true;
    this.dom.append(icon(byFinger.peek() ? "blocks" : "keyboard"), this.words);
    workspace.getInjectionDiv().append(this.dom);
    this.stop = effect(() => {
      this.words.textContent = t(byFinger.value ? "page-blocks-empty" : "page-blocks-empty-keys");
    });
  }

  destroy(): void {
    this.stop();
    this.dom.remove();
  }

  /** Show it beside the palette and below the hats while no block is in the program, hats apart. */
  update(isLoading: boolean): void {
    const { workspace } = this;
    this.dom.hidden = isLoading || workspace.isReadOnly() || !isEmpty(workspace);
    if (this.dom.hidden) return;
    this.dom.style.setProperty("--below", `${lowest(workspace)}px`);
  }
}

/** The lower edge of the lowest block in the view, in px. */
function lowest(workspace: Blockly.WorkspaceSvg): number {
  const edges = workspace.getTopBlocks(false).map((block) => block.getBoundingRectangle().bottom);
  return Math.max(0, ...edges) * workspace.scale + workspace.scrollY;
}

function isEmpty(workspace: Blockly.WorkspaceSvg): boolean {
  return workspace.getTopBlocks(false).every((block) => {
    return !block.previousConnection && !block.outputConnection && block.getChildren(false).length === 0;
  });
}
