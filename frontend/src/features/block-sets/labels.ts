/** The palette's tabs with their blocks' texts. */

import * as Blockly from "blockly/core";
import { t } from "../../i18n";
import type { Entry, Tab } from "../../model/shown-blocks";
import { blocksOf, CHANGING, nameOf } from "../../model/shown-blocks";
import { ownTab } from "../../views/blocks/categories";
import { fetchPalette, installPalette } from "../../views/blocks/palette";
import { prepare } from "../../views/blocks/prepare";
import type { Group } from "./ticks";

export interface LabelledTab extends Group {
  readonly title: string;
  /** Each block's text, by its name in sets. */
  readonly labels: ReadonlyMap<string, string>;
}

type State = Blockly.serialization.blocks.State;
type NamedTab = Tab & { readonly name?: string };

/** Function calls show only the function's name. */
const NAMELESS: Readonly<Record<string, string>> = {
  procedures_callnoreturn: "page-blocks-call",
  procedures_callreturn: "page-blocks-call-value",
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
  return {
    category: tab.category ?? "",
    title: tab.name ?? "",
    blocks: blocksOf(tab),
    labels: new Map(distinct(labels)),
  };
}

/** Blocks with the same text also show their names. */
function distinct(labels: readonly (readonly [string, string])[]): (readonly [string, string])[] {
  const texts = labels.map(([, text]) => text);
  const isAlone = (text: string) => texts.indexOf(text) === texts.lastIndexOf(text);
  return labels.map(([name, text]) => [name, isAlone(text) ? text : `${text} (${name})`]);
}

/** A block's text, with a gap for each input. */
function labelOf(entry: Entry, workspace: Blockly.Workspace): string {
  const nameless = NAMELESS[entry.type ?? ""];
  if (nameless) return t(nameless);
  const { inputs: _, ...bare } = entry as State;
  const block = Blockly.serialization.blocks.append(bare, workspace);
  return block.toString(undefined, GAP).trim() || (entry.type ?? "");
}
