/** Search among the palette's blocks and in the program: Blockly's plugins in the page's language. */

import { WorkspaceSearch } from "@blockly/plugin-workspace-search";
import "@blockly/toolbox-search";
import * as Blockly from "blockly/core";

import { t } from "../../i18n";

type FlyoutItem = Blockly.utils.toolbox.FlyoutItemInfo;
const KIND = "search";
/** Shorter searches only find words of the same length. */
const SHORTEST = 3;

/** The search tab of the palette. */
export function searchTab(): Blockly.utils.toolbox.ToolboxItemInfo {
  const tab = { kind: KIND, name: t("page-blocks-search"), contents: [] };
  return tab as unknown as Blockly.utils.toolbox.ToolboxItemInfo;
}

/** The plugin's private members that are used here. */
interface Searching {
  readonly searchField?: HTMLInputElement;
  readonly blockSearcher: { blockTypesMatching(words: string): FlyoutItem[] };
}

/** Translate the palette's search and include the last typed letter. */
export function registerSearchTab(): void {
  const { TOOLBOX_ITEM } = Blockly.registry.Type;
  const Plugin = Blockly.registry.getClass(TOOLBOX_ITEM, KIND) as unknown as typeof Blockly.ToolboxCategory;
  class SearchTab extends Plugin {
    private words: string | null = null;

    protected override createDom_(): HTMLDivElement {
      const dom = super.createDom_();
      const input = dom.querySelector("input");
      input?.setAttribute("placeholder", t("page-blocks-search"));
      input?.setAttribute("aria-label", t("page-blocks-search-blocks"));
      // The plugin searches on keydown, before the input has the new letter.
      input?.addEventListener("input", () => this.matchBlocks());
      return dom;
    }

    /** Replaces the plugin's method. */
    matchBlocks(): void {
      const { searchField, blockSearcher } = this as unknown as Searching;
      const words = searchField?.value.trim() ?? "";
      if (words === this.words) return;
      this.words = words;
      const found = words ? blockSearcher.blockTypesMatching(words) : [];
      this.flyoutItems_ = found.length ? found : [nothing(words)];
      if (words) Blockly.utils.aria.announceDynamicAriaState(t("page-blocks-search-found", { count: found.length }));
      this.parentToolbox_.refreshSelection();
    }

    /** Ctrl+B; the plugin's own version blocks the keyboard when a block of the palette has the focus. */
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

    // Focus the palette first: its blocks must not have the focus while they are replaced.
    private takeFocus(): boolean {
      Blockly.getFocusManager().focusTree(this.parentToolbox_ as Blockly.Toolbox);
      Blockly.getFocusManager().focusNode(this);
      return true;
    }
  }
  Blockly.registry.register(TOOLBOX_ITEM, KIND, SearchTab, true);
}

function nothing(words: string): FlyoutItem {
  const text = words.length < SHORTEST ? t("page-blocks-search-hint") : t("page-blocks-search-nothing");
  return { kind: "label", text } as FlyoutItem;
}

/** Ctrl+F in the program. */
export class ProgramSearch extends WorkspaceSearch {
  protected override createTextInput(): HTMLInputElement {
    const input = super.createTextInput();
    input.placeholder = input.ariaLabel = t("page-blocks-search-program");
    return input;
  }

  protected override createNextBtn(): HTMLButtonElement {
    return labelled(super.createNextBtn(), t("page-blocks-next"));
  }

  protected override createPreviousBtn(): HTMLButtonElement {
    return labelled(super.createPreviousBtn(), t("page-blocks-previous"));
  }

  protected override createCloseBtn(): HTMLButtonElement {
    return labelled(super.createCloseBtn(), t("page-blocks-close"));
  }
}

function labelled(button: HTMLButtonElement, label: string): HTMLButtonElement {
  button.ariaLabel = label;
  return button;
}
