/** A picture of a block, drawn by Blockly. */

import * as Blockly from "blockly/core";

import type { Island } from "../../ui/island";
import { followTheme, pictureOf, pictureOptions } from "./drawing";
import { prepare } from "./prepare";

type State = Blockly.serialization.blocks.State;

const MARGIN = 8;

export class BlockPicture implements Island {
  private readonly host = document.createElement("div");
  readonly dom = pictureOf(this.host);
  private workspace: Blockly.WorkspaceSvg | null = null;
  private shown: State | null = null;
  private readonly end: () => void;

  /** @param most The scale of a block that has room. */
  constructor(private readonly most = 1) {
    prepare();
    this.dom.classList.add("block-picture");
    this.end = followTheme(() => this.workspace);
  }

  destroy(): void {
    this.end();
    this.workspace?.dispose();
    this.dom.remove();
  }

  /** Blockly can only draw once the element has a size; a wide block is scaled down. */
  resize(): void {
    if (!this.dom.clientWidth) return;
    this.workspace ??= Blockly.inject(this.host, pictureOptions());
    if (this.shown) this.draw(this.shown, this.workspace);
  }

  show(block: State | null): void {
    this.shown = block;
    this.dom.hidden = block === null;
    this.resize();
  }

  private draw(state: State, workspace: Blockly.WorkspaceSvg): void {
    workspace.clear();
    const drawn = Blockly.serialization.blocks.append(state, workspace) as Blockly.BlockSvg;
    Blockly.renderManagement.triggerQueuedRenders(workspace);
    this.dom.ariaLabel = drawn.toString();
    this.fit(drawn, workspace);
  }

  private fit(block: Blockly.BlockSvg, workspace: Blockly.WorkspaceSvg): void {
    const { width, height } = block.getHeightWidth();
    const scale = Math.min(this.most, this.dom.clientWidth / (width + 2 * MARGIN));
    block.moveTo(new Blockly.utils.Coordinate(MARGIN, MARGIN));
    this.host.style.width = `${scale * (width + 2 * MARGIN)}px`;
    this.host.style.height = `${scale * (height + 2 * MARGIN)}px`;
    workspace.setScale(scale);
    Blockly.svgResize(workspace);
  }
}
