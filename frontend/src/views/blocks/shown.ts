/** The palette reduced to the blocks of a set. */

import type * as Blockly from "blockly/core";

import { CHANGING, shownEntries, shownTabs, shows, type Tab } from "../../model/shown-blocks";
import type { BlockSet } from "../../protocol/messages";
import { ownTab } from "./categories";
import type { Palette } from "./palette";
import { searchTab } from "./search";

type Toolbox = Blockly.utils.toolbox.ToolboxInfo;
type Items = Blockly.utils.toolbox.FlyoutItemInfo[];

export function toolboxOf({ toolbox }: Palette, set: BlockSet): Toolbox {
  const tabs = [...toolbox.contents, ownTab()] as (Tab & { custom?: string })[];
  const shown = shownTabs(tabs, set) as Toolbox["contents"];
  return { ...toolbox, contents: [searchTab(), ...shown] };
}

/** Apply the set to the tabs whose blocks depend on the program. */
export function limitTabs(workspace: Blockly.WorkspaceSvg, palette: Palette, set: () => BlockSet): void {
  for (const { custom = "", category = "" } of palette.toolbox.contents as Tab[]) {
    const all = custom in CHANGING && workspace.getToolboxCategoryCallback(custom);
    if (!all) continue;
    workspace.registerToolboxCategoryCallback(custom, (source) =>
      limited(all(source) as Items, custom, category, set()),
    );
  }
}

function limited(items: Items, custom: string, category: string, set: BlockSet): Items {
  const shown = shownEntries(items, category, set) as Items;
  // The tab's button creates its first block.
  const makes = shows(set, category, CHANGING[custom]?.[0] ?? "");
  return makes ? shown : shown.filter(({ kind }) => kind !== "button");
}
