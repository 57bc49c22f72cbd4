/** Search among the palette's blocks and in the program: Blockly's plugins in the page's language. */

import { WorkspaceSearch } from "@blockly/plugin-workspace-search";
import "@blockly/toolbox-search";
import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { preferences } from "../../model/preferences";
import type { Block } from "../../protocol/messages";
import { icon } from "../../ui/icons";
import { actionsOf } from "./actions";
import { labelsOf } from "./line-labels";
import { found, type Item as Offered, type Section } from "./offers";
import type { GroupInfo } from "./palette-group";
import { paletteWords } from "./palette-words";
import { searchedIn, searchPlugin } from "./patches";
import { indexOf, type Nearest, type SearchIndex } from "./search-index";

type FlyoutItem = Blockly.utils.toolbox.FlyoutItemInfo;
type Item = Blockly.utils.toolbox.ToolboxItemInfo;
const KIND = "search";
/** Shorter searches only find words of the same length. */
const SHORTEST = 3;

/** The search tab of the palette. */
export function searchTab(): Blockly.utils.toolbox.ToolboxItemInfo {
  const tab = { kind: KIND, name: t("page-blocks-search"), contents: [] };
  return tab as unknown as Blockly.utils.toolbox.ToolboxItemInfo;
}

/** Translate the palette's search and include the last typed letter. */
export function registerSearchTab(): void {
  const { TOOLBOX_ITEM } = Blockly.registry.Type;
  class SearchTab extends searchPlugin(KIND) {
    /** Every workspace has a search, and the plugin's own value would give all of them the same id. */
    protected readonly SEARCH_INPUT_ID = Blockly.utils.idGenerator.getNextUniqueId();
    private words: string | null = null;
    private index: SearchIndex | null = null;
    /** The search field, in the flyout's head. */
    readonly head = document.createElement("div");

    protected override createDom_(): HTMLDivElement {
      const dom = super.createDom_();
      fillHead(this.head, dom.querySelector("input")!);
      // The plugin searches on keydown, before the input has the new letter.
      this.head.addEventListener("input", () => this.matchBlocks());
      nameTab(dom, this.rowContents_);
      // At the end of the click: during it, the browser moves the focus to the tab.
      dom.addEventListener("click", () => focusOpened(this, this.parentToolbox_ as Blockly.Toolbox));
      // The head is only shown with a flyout, which needs an item.
      this.flyoutItems_ = [nothing("")];
      return dom;
    }

    /** Replaces the plugin's index, which knows each field alone; ours waits for the first search. */
    protected initBlockSearcher(): void {}

    /** Replaces the plugin's method. */
    matchBlocks(): void {
      const words = searchedIn(this);
      if (words === this.words) return;
      this.words = words;
      this.index ??= indexOf(this.workspace_);
      this.flyoutItems_ = words ? foundBy(words, this.index, this.workspace_) : [nothing("")];
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
        callback: () => focusTab(this, this.parentToolbox_ as Blockly.Toolbox),
      });
    }
  }
  Blockly.registry.register(TOOLBOX_ITEM, KIND, SearchTab, true);
}

/** Focus the palette first: its blocks must not have the focus while they are replaced. */
function focusTab(tab: Blockly.ToolboxCategory, palette: Blockly.Toolbox): boolean {
  Blockly.getFocusManager().focusTree(palette);
  Blockly.getFocusManager().focusNode(tab);
  return true;
}

/** A second click closes a palette that does not stay open: the search field is hidden then. */
function focusOpened(tab: Blockly.ToolboxCategory, palette: Blockly.Toolbox): void {
  if (palette.getSelectedItem() === tab) focusTab(tab, palette);
}

/** The blocks with these words, and those that others call so; or else the most similar ones. */
function foundBy(words: string, index: SearchIndex, workspace: Blockly.WorkspaceSvg): FlyoutItem[] {
  const matching = index.matching(words);
  const known = new Set(matching);
  const foreign = index.foreign(words).map((near) => withoutKnown(near, known));
  const near = matching.length || foreign.length ? foreign : index.similar(words);
  const items = [...sorted(matching, workspace), ...near.flatMap((one) => headed(one, workspace))];
  // Of two blocks that do the same, one is shown.
  announce(items.filter(({ kind }) => kind === "block").length);
  return items.length ? items : [nothing(words)];
}

function tabsOf(workspace: Blockly.WorkspaceSvg): readonly Item[] {
  return workspace.options.languageTree?.contents ?? [];
}

function fillHead(head: HTMLElement, input: HTMLInputElement): void {
  input.placeholder = t("page-blocks-search");
  input.ariaLabel = t("page-blocks-search-blocks");
  head.className = "lbSearchHead";
  head.append(icon("find"), input);
}

/** Only the strip of a phone has room for it. */
function nameInStrip(): HTMLElement {
  const name = document.createElement("span");
  name.className = "lbSearchName";
  name.textContent = t("page-blocks-search");
  return name;
}

function nameTab(dom: HTMLElement, row: HTMLElement | null): void {
  row?.replaceChildren(icon("find"), nameInStrip());
  dom.classList.add("lbSearch");
  dom.ariaLabel = dom.title = t("page-blocks-search-blocks");
  dom.removeAttribute("aria-labelledby");
  // The plugin gives it to the search field too, which has the focus.
  dom.removeAttribute("id");
}

/** The found blocks in the order in which the palette shows them. */
function sorted(matching: readonly Offered[], workspace: Blockly.WorkspaceSvg): FlyoutItem[] {
  return ableFirst(
    matching,
    workspace,
    tabsOf(workspace).flatMap((tab) => (tab as Partial<GroupInfo>).first ?? []),
  );
}

/** Blocks with those at the end that the robot can't do; those of `first` come first. */
function ableFirst(
  blocks: readonly Offered[],
  workspace: Blockly.WorkspaceSvg,
  first: readonly Section[] = [],
): FlyoutItem[] {
  const { lacks, title } = actionsOf(workspace)?.robot() ?? { lacks: new Set<string>(), title: "" };
  const { stage } = preferences.peek();
  return found(blocks, first, { lacks, stage }, paletteWords(title)) as FlyoutItem[];
}

/** Blocks under a sentence, which is as wide as the palette. */
function headed({ sentence, blocks }: Nearest, workspace: Blockly.WorkspaceSvg): FlyoutItem[] {
  const lines = sentence ? labelsOf(sentence) : [];
  return [...(lines as FlyoutItem[]), ...ableFirst(blocks, workspace)];
}

/** The blocks that are not known yet; they are from now on. */
function withoutKnown({ sentence, blocks }: Nearest, known: Set<Offered>): Nearest {
  const own = blocks.filter((block) => !known.has(block));
  for (const block of own) known.add(block);
  return { sentence: own.length ? sentence : "", blocks: own };
}

function announce(count: number): void {
  Blockly.utils.aria.announceDynamicAriaState(t("page-blocks-search-found", { count }));
}

function nothing(words: string): FlyoutItem {
  const text = words.length < SHORTEST ? t("page-blocks-search-hint") : t("page-blocks-search-nothing");
  return { kind: "label", text } as FlyoutItem;
}

/** The part of a program that is not drawn. */
export interface Hidden {
  /** Read all of it, and call a function. */
  prepare(done: () => void): void;
  /** The blocks with these words, in small letters, among what has been read. */
  find(words: string): Block[];
  /** Draw a block and those around it. */
  draw(block: Block): void;
}

/** Found blocks that are drawn at once; the next ones are drawn when the user has gone through these. */
const DRAWN = 5;

/** Ctrl+F in the program; it draws what it finds. */
export class ProgramSearch extends WorkspaceSearch {
  constructor(
    workspace: Blockly.WorkspaceSvg,
    private readonly hidden: Hidden,
  ) {
    super(workspace);
  }

  override open(): void {
    super.open();
    this.hidden.prepare(() => {
      if (this.searchText) this.searchAndHighlight(this.searchText, true);
    });
  }

  override next(): void {
    if (this.currentBlockIndex === this.blocks.length - 1 && this.drawFound()) {
      this.searchAndHighlight(this.searchText, true);
    }
    super.next();
  }

  override searchAndHighlight(words: string, preserveCurrent?: boolean): void {
    super.searchAndHighlight(words, preserveCurrent);
    if (this.searchText && !this.blocks.length && this.drawFound()) super.searchAndHighlight(words, preserveCurrent);
  }

  /** Draw the next found blocks; return whether there are any. */
  private drawFound(): boolean {
    const found = this.hidden.find(this.searchText.toLowerCase()).slice(0, DRAWN);
    for (const block of found) this.hidden.draw(block);
    return found.length > 0;
  }

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
