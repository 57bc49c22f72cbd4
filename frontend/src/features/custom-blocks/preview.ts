/** A preview of a block, drawn by Blockly. */

import { effect } from "@preact/signals";
import * as Blockly from "blockly/core";
import { theme } from "../../model/preferences";
import type { CustomBlockPreview } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import { Checker } from "../../views/blocks/checker";
import type { Definition } from "../../views/blocks/fields";
import { MEDIA } from "../../views/blocks/media";
import { defineBlocks } from "../../views/blocks/palette";
import { prepare } from "../../views/blocks/prepare";
import { themeOf } from "../../views/blocks/themes";

/** Keeps previews apart from the program's blocks of that type. */
const PREVIEW = "lb_preview_";
const MARGIN = 8;

export class Preview implements Island {
  readonly dom = document.createElement("div");
  private readonly host = document.createElement("div");
  private workspace: Blockly.WorkspaceSvg | null = null;
  private shown: CustomBlockPreview | null = null;
  private readonly end: () => void;

  constructor() {
    prepare();
    this.dom.className = "blocks custom-block-preview";
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
    this.workspace ??= Blockly.inject(this.host, options());
    this.redraw();
  }

  show(preview: CustomBlockPreview | null): void {
    this.shown = preview;
    this.dom.hidden = preview === null;
    this.resize();
  }

  private redraw(): void {
    if (this.shown) this.draw(this.shown);
  }

  private setTheme(chosen: Blockly.Theme): void {
    this.workspace?.setTheme(chosen);
  }

  private draw({ name, definition, block }: CustomBlockPreview): void {
    const { workspace } = this;
    if (!workspace) return;
    const type = PREVIEW + name;
    workspace.clear();
    defineBlocks([{ ...definition, type } as Definition]);
    const drawn = Blockly.serialization.blocks.append(
      { ...block, type } as Blockly.serialization.blocks.State,
      workspace,
    ) as Blockly.BlockSvg;
    Blockly.renderManagement.triggerQueuedRenders(workspace);
    this.dom.ariaLabel = drawn.toString();
    this.fit(drawn);
  }

  private fit(block: Blockly.BlockSvg): void {
    const { width, height } = block.getHeightWidth();
    const scale = Math.min(1, this.dom.clientWidth / (width + 2 * MARGIN));
    block.moveTo(new Blockly.utils.Coordinate(MARGIN, MARGIN));
    this.host.style.width = `${scale * (width + 2 * MARGIN)}px`;
    this.host.style.height = `${scale * (height + 2 * MARGIN)}px`;
    this.workspace?.setScale(scale);
    Blockly.svgResize(this.workspace!);
  }
}

function options(): Blockly.BlocklyOptions {
  return {
    renderer: "zelos",
    theme: themeOf(theme.peek()),
    media: MEDIA,
    readOnly: true,
    sounds: false,
    zoom: { maxScale: 1, minScale: 0.1 },
    move: { scrollbars: false, drag: false, wheel: false },
    plugins: { connectionChecker: Checker },
  };
}
