/** A picture of a block, drawn by Blockly. */

import { effect } from "@preact/signals";
import * as Blockly from "blockly/core";

import { theme } from "../../model/preferences";
import type { Island } from "../../ui/island";
import { pictureOptions } from "./drawing";
import { prepare } from "./prepare";
import { themeOf } from "./themes";

type State = Blockly.serialization.blocks.State;

const MARGIN = 8;

export class BlockPicture implements Island {
  readonly dom = document.createElement("div");
  private readonly host = document.createElement("div");
  private workspace: Blockly.WorkspaceSvg | null = null;
  private shown: State | null = null;
  private readonly end: () => void;

  /** @param most The scale of a block that has room. */
  constructor(private readonly most = 1) {
    prepare();
    this.dom.className = "blocks block-picture";
    this.dom.setAttribute("role", "img");
    // It is a picture: nothing in it takes the focus or a click.
    this.host.inert = true;
    this.dom.append(this.host);
    this.end = effect(() => this.setTheme(themeOf(theme.value)));
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
    this.redraw();
  }

  show(block: State | null): void {
    this.shown = block;
    this.dom.hidden = block === null;
    this.resize();
  }

  private redraw(): void {
    if (this.shown) this.draw(this.shown);
  }

  private setTheme(chosen: Blockly.Theme): void {
    this.workspace?.setTheme(chosen);
  }

  private draw(state: State): void {
    const { workspace } = this;
    if (!workspace) return;
    workspace.clear();
    const drawn = Blockly.serialization.blocks.append(state, workspace) as Blockly.BlockSvg;
    Blockly.renderManagement.triggerQueuedRenders(workspace);
    this.dom.ariaLabel = drawn.toString();
    this.fit(drawn);
  }

  private fit(block: Blockly.BlockSvg): void {
    const { width, height } = block.getHeightWidth();
    const scale = Math.min(this.most, this.dom.clientWidth / (width + 2 * MARGIN));
    block.moveTo(new Blockly.utils.Coordinate(MARGIN, MARGIN));
    this.host.style.width = `${scale * (width + 2 * MARGIN)}px`;
    this.host.style.height = `${scale * (height + 2 * MARGIN)}px`;
    this.workspace?.setScale(scale);
    Blockly.svgResize(this.workspace!);
  }
}
