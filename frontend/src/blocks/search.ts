/** Search among the palette's blocks and in the program: Blockly's plugins in the page's language. */

import { WorkspaceSearch } from "@blockly/plugin-workspace-search";
import "@blockly/toolbox-search";
import * as Blockly from "blockly/core";

import { t } from "../i18n";

type FlyoutItem = Blockly.utils.toolbox.FlyoutItemInfo;
const KIND = "search";
/** Letters of a word, below which the search finds only words that are no longer. */
const SHORTEST = 3;

/** The search tab of the palette. */
export function searchTab(): Blockly.utils.toolbox.ToolboxItemInfo {
  const tab = { kind: KIND, name: t("blocks.search"), contents: [] };
  return tab as unknown as Blockly.utils.toolbox.ToolboxItemInfo;
}

/** What the plugin's tab has of its own. */
interface Searching {
  readonly searchField?: HTMLInputElement;
  readonly blockSearcher: { blockTypesMatching(words: string): FlyoutItem[] };
}

/** Let the palette's search speak the page's language, and find what is typed with its last letter. */
export function registerSearchTab(): void {
  const { TOOLBOX_ITEM } = Blockly.registry.Type;
  const Plugin = Blockly.registry.getClass(TOOLBOX_ITEM, KIND) as unknown as typeof Blockly.ToolboxCategory;
  class SearchTab extends Plugin {
    private words: string | null = null;

    protected override createDom_(): HTMLDivElement {
      const dom = super.createDom_();
      const input = dom.querySelector("input");
      input?.setAttribute("placeholder", t("blocks.search"));
      input?.setAttribute("aria-label", t("blocks.search_blocks"));
      // The plugin looks when a key goes down, before its letter is there.
      input?.addEventListener("input", () => this.matchBlocks());
      return dom;
    }

    /** In place of the plugin's, which calls it too. */
    matchBlocks(): void {
      const { searchField, blockSearcher } = this as unknown as Searching;
      const words = searchField?.value.trim() ?? "";
      if (words === this.words) return;
      this.words = words;
      const found = words ? blockSearcher.blockTypesMatching(words) : [];
      this.flyoutItems_ = found.length ? found : [nothing(words)];
      if (words) Blockly.utils.aria.announceDynamicAriaState(t("blocks.search_found", { count: found.length }));
      this.parentToolbox_.refreshSelection();
    }

    /** Ctrl+B, as the plugin's own, which locks the keyboard when it is pressed among the palette's blocks. */
    protected registerShortcut(): void {
      const { registry } = Blockly.ShortcutRegistry;
      const { B, CTRL } = Blockly.utils.KeyCodes;
      registry.register({
        name: "startSearch",
        keyCodes: [registry.createSerializedKey(B, [CTRL])],
        preconditionFn: () => !Blockly.getFocusManager().ephemeralFocusTaken(),
        callback: () => this.takeFocus(),
      });
    }

    // By way of the palette: its blocks must not have the focus while others take their place.
    private takeFocus(): boolean {
      Blockly.getFocusManager().focusTree(this.parentToolbox_ as Blockly.Toolbox);
      Blockly.getFocusManager().focusNode(this);
      return true;
    }
  }
  Blockly.registry.register(TOOLBOX_ITEM, KIND, SearchTab, true);
}

function nothing(words: string): FlyoutItem {
  const text = words.length < SHORTEST ? t("blocks.search_hint") : t("blocks.search_nothing");
  return { kind: "label", text } as FlyoutItem;
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
