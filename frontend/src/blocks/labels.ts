/** The tabs of the palette with what stands on their blocks, as text. */

import * as Blockly from "blockly/core";

import type { Entry, Tab } from "../blocksets/rule";
import { blocksOf, CHANGING, nameOf } from "../blocksets/rule";
import type { Group } from "../blocksets/ticks";
import { t } from "../i18n";
import { prepare } from ".";
import { ownTab } from "./categories";
import { fetchPalette, installPalette } from "./palette";

export interface LabelledTab extends Group {
  readonly title: string;
  /** What stands on each block, by the name that sets have for it. */
  readonly labels: ReadonlyMap<string, string>;
}

type State = Blockly.serialization.blocks.State;
type NamedTab = Tab & { readonly name?: string };

/** Calls of functions say nothing but the name of what they call. */
const NAMELESS: Readonly<Record<string, string>> = {
  procedures_callnoreturn: "blocks.call",
  procedures_callreturn: "blocks.call_value",
};
const GAP = "…";

/** The tabs in a language, in the order of the palette. */
export async function labelledTabs(code: string): Promise<readonly LabelledTab[]> {
  prepare();
  const palette = await fetchPalette(code);
  installPalette(palette);
  const workspace = new Blockly.Workspace();
  try {
    return ([...palette.toolbox.contents, ownTab()] as NamedTab[]).map((tab) => labelled(tab, workspace));
  } finally {
    workspace.dispose();
  }
}

function labelled(tab: NamedTab, workspace: Blockly.Workspace): LabelledTab {
  const entries: readonly Entry[] = tab.contents ?? (CHANGING[tab.custom ?? ""] ?? []).map((type) => ({ type }));
  const labels = entries.filter(nameOf).map((entry) => [nameOf(entry), labelOf(entry, workspace)] as const);
  return { category: tab.category ?? "", title: tab.name ?? "", blocks: blocksOf(tab), labels: new Map(told(labels)) };
}

/** Of blocks that say the same each says its name too. */
function told(labels: readonly (readonly [string, string])[]): (readonly [string, string])[] {
  const texts = labels.map(([, text]) => text);
  const isAlone = (text: string) => texts.indexOf(text) === texts.lastIndexOf(text);
  return labels.map(([name, text]) => [name, isAlone(text) ? text : `${text} (${name})`]);
}

/** What a block says, with a gap for what is put into it. */
function labelOf(entry: Entry, workspace: Blockly.Workspace): string {
  const nameless = NAMELESS[entry.type ?? ""];
  if (nameless) return t(nameless);
  const { inputs: _, ...bare } = entry as State;
  const block = Blockly.serialization.blocks.append(bare, workspace);
  return block.toString(undefined, GAP).trim() || (entry.type ?? "");
}
