/** Search among the palette's blocks and in the program: Blockly's plugins in the page's language. */

import { WorkspaceSearch } from "@blockly/plugin-workspace-search";
import "@blockly/toolbox-search";
import * as Blockly from "blockly/core";

import { t } from "../i18n";

type FlyoutItem = Blockly.utils.toolbox.FlyoutItemInfo;
const KIND = "search";

/** The search tab of the palette. */
export function searchTab(): Blockly.utils.toolbox.ToolboxItemInfo {
  const tab = { kind: KIND, name: t("blocks.search"), contents: [] };
  return tab as unknown as Blockly.utils.toolbox.ToolboxItemInfo;
}

/** Let the palette's search speak the page's language. */
export function registerSearchTab(): void {
  const { TOOLBOX_ITEM } = Blockly.registry.Type;
  const Plugin = Blockly.registry.getClass(TOOLBOX_ITEM, KIND) as unknown as typeof Blockly.ToolboxCategory;
  class SearchTab extends Plugin {
    protected override createDom_(): HTMLDivElement {
      const dom = super.createDom_();
      const input = dom.querySelector("input");
      input?.setAttribute("placeholder", t("blocks.search"));
      input?.setAttribute("aria-label", t("blocks.search_blocks"));
      return dom;
    }

    override getContents(): FlyoutItem[] | string {
      const contents = super.getContents();
      return typeof contents === "string" ? contents : contents.map(translate);
    }
  }
  Blockly.registry.register(TOOLBOX_ITEM, KIND, SearchTab, true);
}

// The plugin's own words, as long as it takes none from Blockly's messages.
const WORDS: Record<string, string> = {
  "Type to search for blocks": "blocks.search_hint",
  "No matching blocks found": "blocks.search_nothing",
};

function translate(item: FlyoutItem): FlyoutItem {
  const { text } = item as { text?: string };
  const key = text === undefined ? undefined : WORDS[text];
  return key ? ({ ...item, text: t(key) } as FlyoutItem) : item;
}

/** Ctrl+F in the program. */
export class ProgramSearch extends WorkspaceSearch {
  protected override createTextInput(): HTMLInputElement {
    const input = super.createTextInput();
    input.placeholder = input.ariaLabel = t("blocks.search_program");
    return input;
  }

  protected override createNextBtn(): HTMLButtonElement {
    return labelled(super.createNextBtn(), t("blocks.next"));
  }

  protected override createPreviousBtn(): HTMLButtonElement {
    return labelled(super.createPreviousBtn(), t("blocks.previous"));
  }

  protected override createCloseBtn(): HTMLButtonElement {
    return labelled(super.createCloseBtn(), t("blocks.close"));
  }
}

function labelled(button: HTMLButtonElement, label: string): HTMLButtonElement {
  button.ariaLabel = label;
  return button;
}
