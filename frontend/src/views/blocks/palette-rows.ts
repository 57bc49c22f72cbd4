/** The ids of the rows of the palette, in which its tabs can be clicked. */

import type { IToolboxItem } from "blockly/core";

const ROW = ".row";

/**
 * Give the row of a tab an id of its own.
 *
 * Blockly gives the row, as the tab's click target, the id of the element around it, and finds the clicked tab
 * by it: see `tabOf`.
 */
export function nameRow(tab: IToolboxItem): void {
  tab.getClickTarget()?.setAttribute("id", tab.getId() + ROW);
}

/** The id of the tab that an element with this id belongs to. */
export function tabOf(id: string): string {
  return id.endsWith(ROW) ? id.slice(0, -ROW.length) : id;
}
