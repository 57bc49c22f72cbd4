/** Scrolls the program while a block is dragged beyond its edge, and drops it where the pointer is. */

import { ScrollBlockDragger } from "@blockly/plugin-scroll-options";
import * as Blockly from "blockly/core";

/**
 * Only the pointer decides, and slowly: the far end of a wide block is often beyond the edge. Speeds in px
 * per ms.
 */
export const EDGE = { slowBlockStartDistance: Infinity, slowMouseSpeed: 0.2, fastMouseSpeed: 0.6 };

/** As in Scratch, in units of the workspace: how near a block snaps in, stays, and how much it prefers where it is. */
const SNAPPING = { snapRadius: 48, connectingSnapRadius: 68, currentConnectionPreference: 20 };

/** Call it once, before the first workspace is created. */
export function snapAsInScratch(): void {
  Object.assign(Blockly.config, SNAPPING);
}

/** The editor has it while something is dragged: the bin is needed then. */
const DRAGGING = "lb-dragging";

/** Over the palette it does not scroll: blocks come from there, and go there to be deleted. */
export class Dragger extends ScrollBlockDragger {
  override onDragStart(event: PointerEvent): Blockly.IDraggable {
    this.editor.classList.add(DRAGGING);
    return super.onDragStart(event);
  }

  /**
   * Look for the place once more before the block is dropped. While blocks wait to be drawn, their places are
   * those of the last frame: a quick drop would land beside the gap that has just closed or opened.
   */
  override onDragEnd(event: PointerEvent, delta?: Blockly.utils.Coordinate): void {
    if (delta && event instanceof PointerEvent) {
      Blockly.renderManagement.triggerQueuedRenders(this.draggable.workspace);
      this.onDrag(event, delta);
    }
    super.onDragEnd(event);
    this.editor.classList.remove(DRAGGING);
  }

  override onDragRevert(event?: PointerEvent | KeyboardEvent): void {
    super.onDragRevert(event);
    this.editor.classList.remove(DRAGGING);
  }

  private get editor(): Element {
    return this.workspace.getInjectionDiv();
  }

  private get workspace(): Blockly.WorkspaceSvg {
    return this.draggable.workspace as Blockly.WorkspaceSvg;
  }

  protected override scrollWorkspaceWhileDragging_(event: PointerEvent): void {
    if (isOverPalette(this.workspace, event)) this.stopAutoScrolling();
    else super.scrollWorkspaceWhileDragging_(event);
  }
}

/** Whether the pointer is beside the program, over the palette at its left or below it. */
function isOverPalette(workspace: Blockly.WorkspaceSvg, { clientX, clientY }: PointerEvent): boolean {
  const metrics = workspace.getMetricsManager();
  const { left, top } = workspace.getParentSvg().getBoundingClientRect();
  if (workspace.horizontalLayout) return clientY > top + metrics.getViewMetrics().height;
  return clientX < left + metrics.getAbsoluteMetrics().left;
}
