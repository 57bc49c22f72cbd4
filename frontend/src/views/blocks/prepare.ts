/** Blockly as LearnBlock uses it: its blocks, menus, keys and search. */

import { nameEditors } from "./editor-names";
import { registerMenus } from "./menus";
import { prepareBlockly } from "./palette";
import { registerSearchTab } from "./search";

let prepared = false;

/** Blockly keeps its registries for the whole page. */
export function prepare(): void {
  if (prepared) return;
  prepared = true;
  prepareBlockly();
  registerMenus();
  nameEditors();
  registerSearchTab();
}
