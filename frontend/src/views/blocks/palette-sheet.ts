/** The open part of the palette on a phone: a sheet that comes up from the bottom, above the strip of groups. */

import * as Blockly from "blockly/core";

import { HEAD_HEIGHT, PaletteFlyout } from "./palette-flyout";

/** The part of the program that stays in sight above the sheet, in CSS pixels. */
const PEEK = 56;
const BELOW = 16;

export class PaletteSheet extends PaletteFlyout {
  private top = 0;

  constructor(options: Blockly.Options) {
    super(options);
    this.getWorkspace().setNavigator(new SheetNavigator(this));
  }

  override get headTop(): number {
    return this.top - HEAD_HEIGHT;
  }

  override getX(): number {
    return 0;
  }

  override getY(): number {
    return this.top;
  }

  protected override get fullWidth(): number {
    return this.targetWorkspace.getMetricsManager().getViewMetrics().width;
  }

  override position(): void {
    if (!this.isVisible() || !this.targetWorkspace.isVisible()) return;
    const { width, height } = this.targetWorkspace.getMetricsManager().getViewMetrics();
    const room = Math.max(0, height - PEEK - HEAD_HEIGHT);
    this.width_ = width;
    this.height_ = Math.min(room, this.contentHeight);
    this.top = height - this.height_;
    this.svgBackground_?.setAttribute("d", `M0 0h${this.width_}v${this.height_}h${-this.width_}z`);
    this.placeAt(this.width_, this.height_, 0, this.top);
  }

  protected override reflowInternal_(): void {
    this.getWorkspace().scale = this.getFlyoutScale();
    this.position();
  }

  private get contentHeight(): number {
    const ends = this.getContents().map((item) => item.getElement().getBoundingRectangle().bottom);
    return Math.ceil(Math.max(0, ...ends) * this.getFlyoutScale()) + BELOW;
  }
}

/** The arrow keys as in a palette at the left: Blockly's own are for blocks in a row. */
class SheetNavigator extends Blockly.FlyoutNavigator {
  override getNextNode(node?: Blockly.IFocusableNode | null): Blockly.IFocusableNode | null {
    return super.getNextNode(node, true);
  }

  override getPreviousNode(node?: Blockly.IFocusableNode | null): Blockly.IFocusableNode | null {
    return super.getPreviousNode(node, true);
  }

  override getInNode(node?: Blockly.IFocusableNode | null): Blockly.IFocusableNode | null {
    return super.getInNode(node, true);
  }

  override getOutNode(node?: Blockly.IFocusableNode | null): Blockly.IFocusableNode | null {
    return super.getOutNode(node, true);
  }
}
