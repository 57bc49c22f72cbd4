/** A group in the palette's rail: its icon in its colour, and its name. */

import * as Blockly from "blockly/core";

import { preferences } from "../../model/preferences";
import { isExclusive, shownEntries } from "../../model/shown-blocks";
import { icon } from "../../ui/icons";
import { actionsOf } from "./actions";
import { COLOURS, type Group, inkOf, isGroup } from "./groups";
import { type FilledTab, type Item, offered, type Section } from "./offers";
import { paletteWords } from "./palette-words";

type Items = Blockly.utils.toolbox.FlyoutItemInfoArray;

export const GROUP = "lb_group";

/** A tab of a group, with its blocks or the name of what creates them. */
export interface GroupTab {
  readonly name: string;
  readonly category: string;
  readonly custom?: string;
  readonly contents?: readonly Item[];
}

/** A group as the toolbox has it. */
export interface GroupInfo {
  readonly kind: typeof GROUP;
  readonly name: string;
  readonly group: string;
  readonly first: readonly Section[];
  readonly tabs: readonly GroupTab[];
  /** All blocks that do not depend on the program, for the search. */
  readonly contents: readonly Item[];
}

export class GroupItem extends Blockly.ToolboxCategory {
  /** Whether all its blocks are shown. */
  open = false;

  get group(): Group {
    const { group } = this.info;
    return isGroup(group) ? group : "my_blocks";
  }

  private get info(): GroupInfo {
    return this.toolboxItemDef_ as unknown as GroupInfo;
  }

  protected override createDom_(): HTMLDivElement {
    const dom = super.createDom_();
    dom.style.setProperty("--group", COLOURS[this.group]);
    dom.style.setProperty("--group-ink", inkOf(this.group));
    return dom;
  }

  protected override createIconDom_(): Element {
    return groupIcon(this.group);
  }

  // The style sheet shows the colour and the selection.
  protected override addColourBorder_(): void {}

  override getContents(): Items {
    const own = actionsOf(this.workspace_);
    const set = own?.shownBlocks() ?? {};
    const tabs = this.info.tabs.map((tab) => this.filled(tab));
    const first = isExclusive(set) ? null : this.info.first;
    const { stage } = preferences.peek();
    const offer = { tabs, first, open: this.open, lacks: own?.robot().lacks ?? new Set<string>(), stage };
    return offered(offer, paletteWords(own?.robot().title ?? "")) as unknown as Items;
  }

  private filled({ name, category, custom, contents }: GroupTab): FilledTab {
    const made = custom ? this.workspace_.getToolboxCategoryCallback(custom)?.(this.workspace_) : null;
    const items = (made as readonly Item[] | null | undefined) ?? contents ?? [];
    return { name, category, items: shownEntries(items, category, actionsOf(this.workspace_)?.shownBlocks() ?? {}) };
  }
}

/** A group's icon on its colour, decorative. */
export function groupIcon(group: Group): HTMLElement {
  const tile = document.createElement("span");
  tile.className = "lbGroupIcon";
  tile.style.setProperty("--group", COLOURS[group]);
  tile.style.setProperty("--group-ink", inkOf(group));
  tile.append(icon(group));
  return tile;
}

export function registerGroups(): void {
  Blockly.registry.register(Blockly.registry.Type.TOOLBOX_ITEM, GROUP, GroupItem, true);
}
