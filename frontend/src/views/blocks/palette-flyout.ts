/** The open part of the palette: below its head, a bit smaller than the program, and as wide as its blocks. */

import * as Blockly from "blockly/core";

/** The blocks' size, whatever the zoom of the program. */
const SCALE = 0.72;
/** CSS pixels. */
export const HEAD_HEIGHT = 48;
/** One width for all groups, because the program beside them would move; longer sentences have several lines. */
const WIDTH = { narrow: 268, wide: 330 };
/** The room of the scrollbar beside the blocks; the style sheet makes it thinner than this. */
const SCROLLBAR = 12;
/** From this width on, the program has room beside the wide palette. */
const WIDE = 1000;

export class PaletteFlyout extends Blockly.VerticalFlyout {
  /** Called when it opens, closes or changes its size. */
  changed: () => void = () => {};

  override getFlyoutScale(): number {
    return SCALE;
  }

  override getY(): number {
    return HEAD_HEIGHT;
  }

  override init(target: Blockly.WorkspaceSvg): void {
    super.init(target);
    // Before it has been opened for the first time, Blockly hides the blocks but not the scrollbar, which would cover a
    // part of the program.
    this.workspace_.scrollbar?.setContainerVisible(false);
  }

  override setVisible(visible: boolean): void {
    super.setVisible(visible);
    this.changed?.();
  }

  protected override positionAt_(width: number, height: number, x: number, y: number): void {
    this.placeAt(width, Math.max(0, height - HEAD_HEIGHT), x, y);
  }

  /** Place its blocks, below its head. */
  protected placeAt(width: number, height: number, x: number, y: number): void {
    super.positionAt_(width, height, x, y);
    this.changed?.();
  }

  /** The position of its head in the view. */
  get headTop(): number {
    return 0;
  }

  protected override layout_(contents: Blockly.FlyoutItem[]): void {
    this.workspace_.scale = this.getFlyoutScale();
    let y = this.MARGIN;
    for (const item of contents) {
      const element = item.getElement();
      element.moveBy(this.left, y);
      y += element.getBoundingRectangle().getHeight();
    }
  }

  /** The longest line of a block, in units of the workspace. */
  get room(): number {
    return (this.fullWidth - SCROLLBAR) / this.getFlyoutScale() - this.left;
  }

  protected get fullWidth(): number {
    const isWide = this.targetWorkspace.getInjectionDiv().clientWidth >= WIDE;
    return isWide ? WIDTH.wide : WIDTH.narrow;
  }

  private get left(): number {
    return this.MARGIN * 1.25;
  }

  protected override reflowInternal_(): void {
    this.workspace_.scale = this.getFlyoutScale();
    if (this.getWidth() === this.fullWidth) return;
    this.width_ = this.fullWidth;
    this.position();
    this.targetWorkspace.resizeContents();
    this.targetWorkspace.recordDragTargets();
  }
}
