/** The red dot of a block with a breakpoint. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";

const SIZE = 17;

export class BreakpointIcon extends Blockly.icons.Icon {
  static readonly TYPE = new Blockly.icons.IconType<BreakpointIcon>("lb_breakpoint");

  constructor(
    block: Blockly.BlockSvg,
    private readonly remove: () => void,
  ) {
    super(block);
    this.setTooltip(t("page-blocks-breakpoint"));
  }

  override getType(): Blockly.icons.IconType<BreakpointIcon> {
    return BreakpointIcon.TYPE;
  }

  override initView(listener: (event: PointerEvent) => void): void {
    if (this.svgRoot) return;
    super.initView(listener);
    const circle = { cx: SIZE / 2, cy: SIZE / 2, r: SIZE / 2 - 1, class: "lbBreakpoint" };
    Blockly.utils.dom.createSvgElement(Blockly.utils.Svg.CIRCLE, circle, this.svgRoot);
  }

  override getSize(): Blockly.utils.Size {
    return new Blockly.utils.Size(SIZE, SIZE);
  }

  override isShownWhenCollapsed(): boolean {
    return true;
  }

  override updateCollapsed(): void {
    // Folded blocks show it too.
  }

  override onClick(): void {
    this.remove();
  }

  protected override getAriaLabel(): string {
    return t("page-blocks-remove-breakpoint");
  }
}
