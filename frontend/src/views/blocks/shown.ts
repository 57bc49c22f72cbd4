/** The palette reduced to the blocks of a set, in its groups. */

import type * as Blockly from "blockly/core";

import { CHANGING, shownEntries, shownTabs, shows, type Tab } from "../../model/shown-blocks";
import type { BlockSet } from "../../protocol/messages";
import { ownTab } from "./categories";
import type { Item } from "./offers";
import type { Palette, PaletteTab } from "./palette";
import { GROUP, type GroupInfo } from "./palette-group";
import { searchTab } from "./search";

type Toolbox = Blockly.utils.toolbox.ToolboxInfo;
type Items = Blockly.utils.toolbox.FlyoutItemInfo[];

/** A search, and the groups with at least one shown block; that of games only where there is one. */
export function toolboxOf({ toolbox }: Palette, set: BlockSet, inGame: boolean): Toolbox {
  const tabs = shownTabs([...toolbox.contents, ownTab()], set);
  const groups = toolbox.groups
    .map((one): GroupInfo => {
      const own = tabs.filter(({ group }) => group === one.group);
      // Hidden, but the search finds it.
      const hidden = one.group === "game" && !inGame ? { hidden: "true" } : {};
      return { kind: GROUP, ...one, ...hidden, tabs: own, contents: own.flatMap(blocksOf) };
    })
    .filter((one) => one.tabs.length > 0);
  return { kind: toolbox.kind, contents: [searchTab(), ...groups] as unknown as Toolbox["contents"] };
}

export function blocksOf({ contents }: PaletteTab): readonly Item[] {
  return (contents ?? []).filter(({ kind }) => kind === "block");
}

/** Apply the set to the tabs whose blocks depend on the program. */
export function limitTabs(workspace: Blockly.WorkspaceSvg, palette: Palette, set: () => BlockSet): void {
  for (const { custom = "", category = "" } of palette.toolbox.contents as readonly Tab[]) {
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
