/** The palette: a rail of groups, and a flyout that stays open beside the program. */

import { computed, effect } from "@preact/signals";
import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { arrange, preferences } from "../../model/preferences";
import { icon } from "../../ui/icons";
import { MORE } from "./offers";
import type { PaletteFlyout } from "./palette-flyout";
import { GroupItem, groupIcon } from "./palette-group";
import { nameRow, tabOf } from "./palette-rows";
import { focusable } from "./patches";

/** Whether the palette stays open, where there is room for it. */
const pinned = computed(() => preferences.value.layout.pinned);

type Selectable = Blockly.ISelectableToolboxItem;

/** A narrower view has no room for the open palette beside the program, in CSS pixels. */
const LEAST_WIDTH = 640;

/** An item that shows more in the head than its name, such as the search. */
interface WithHead {
  readonly head: HTMLElement;
}

export class PaletteToolbox extends Blockly.Toolbox {
  protected readonly head = document.createElement("div");
  protected readonly title = document.createElement("div");
  private readonly pinButton = document.createElement("button");
  private shown = "";
  private stop: () => void = () => {};

  override init(): void {
    super.init();
    this.buildHead();
    this.palette.changed = () => this.placeHead();
    // A palette that begins closed does not change.
    this.placeHead();
    this.workspace_.registerButtonCallback(MORE, () => this.toggleMore());
    this.stop = effect(() => this.keepOpen(pinned.value && this.fits));
  }

  override dispose(): void {
    this.stop();
    super.dispose();
  }

  /** Adapt to the size of the view. */
  fit(): void {
    this.keepOpen(pinned.peek() && this.fits);
  }

  /** Open a group if the palette stays open. */
  begin(): void {
    if (!this.palette.autoClose && !this.getSelectedItem()) this.setSelectedItem(this.usualGroup);
  }

  /** Replace the groups; the open one stays open. */
  override render(toolbox: Blockly.utils.toolbox.ToolboxInfo): void {
    const name = this.getSelectedItem()?.getName();
    super.clearSelection();
    super.render(toolbox);
    this.getToolboxItems().forEach(nameRow);
    const same = this.getToolboxItems().find((item) => item instanceof GroupItem && item.getName() === name);
    if (same) this.setSelectedItem(same);
  }

  /** Most programs begin with a movement. */
  private get usualGroup(): GroupItem | null {
    const groups = this.getToolboxItems().filter((item) => item instanceof GroupItem);
    return groups.find(({ group }) => group === "move") ?? groups[0] ?? null;
  }

  protected get fits(): boolean {
    return this.workspace_.getInjectionDiv().clientWidth >= LEAST_WIDTH;
  }

  protected get palette(): PaletteFlyout {
    return this.getFlyout() as PaletteFlyout;
  }

  private keepOpen(on: boolean): void {
    this.showPin();
    if (on !== this.palette.autoClose) return;
    this.palette.setAutoClose(!on);
    if (on) this.begin();
    else super.clearSelection();
    this.handleToolboxItemResize();
  }

  override getToolboxItemById(id: string): Blockly.IToolboxItem | null {
    return super.getToolboxItemById(tabOf(id));
  }

  override clearSelection(): void {
    if (this.palette.autoClose) super.clearSelection();
  }

  override setSelectedItem(item: Blockly.IToolboxItem | null): void {
    if (!item && !this.palette.autoClose) return;
    this.shown = "";
    super.setSelectedItem(item);
  }

  // Where the palette stays open, a second click keeps the group open.
  protected override updateFlyout_(before: Selectable | null, item: Selectable | null): void {
    if (before === item && !this.palette.autoClose) return;
    super.updateFlyout_(before, item);
    this.shown = JSON.stringify(item?.getContents() ?? "");
    this.showTitle(item);
  }

  /** Refresh the open group, if its blocks have changed. */
  override refreshSelection(): void {
    const now = JSON.stringify(this.getSelectedItem()?.getContents() ?? "");
    if (now === this.shown) return;
    this.shown = now;
    super.refreshSelection();
  }

  override getRestoredFocusableNode(previous: Blockly.IFocusableNode | null): Blockly.IFocusableNode | null {
    const open = this.getSelectedItem() ?? this.usualGroup;
    if (!previous || previous === this) return open && focusable(open);
    return super.getRestoredFocusableNode(previous);
  }

  private toggleMore(): void {
    const item = this.getSelectedItem();
    if (!(item instanceof GroupItem)) return;
    const { scrollY } = this.palette.getWorkspace();
    item.open = !item.open;
    this.refreshSelection();
    if (item.open) this.palette.getWorkspace().scrollbar?.setY(-scrollY);
    else this.palette.scrollToStart();
  }

  private buildHead(): void {
    this.head.className = "lbPaletteHead";
    this.title.className = "lbPaletteTitle";
    this.pinButton.type = "button";
    this.pinButton.className = "lbPin";
    this.pinButton.addEventListener("click", () => arrange({ pinned: !pinned.peek() }));
    this.addHead();
    // The toolbox would take a click on the head for one beside its groups, which closes it.
    this.head.addEventListener("pointerdown", (event) => event.stopPropagation());
  }

  protected addHead(): void {
    this.head.append(this.title, this.pinButton);
    this.HtmlDiv?.append(this.head);
  }

  private showPin(): void {
    const label = t(pinned.peek() ? "page-blocks-unpin" : "page-blocks-pin");
    this.pinButton.hidden = !this.fits;
    this.pinButton.title = this.pinButton.ariaLabel = label;
    this.pinButton.replaceChildren(icon(pinned.peek() ? "pin" : "unpin"));
  }

  protected placeHead(): void {
    this.workspace_.getInjectionDiv().style.setProperty("--palette", `${this.coveredWidth}px`);
    this.head.hidden = !this.palette.isVisible();
    this.head.style.width = `${this.palette.getWidth()}px`;
  }

  /** What the palette takes of the view's width while it stays open, in CSS pixels; a palette that closes covers it. */
  protected get coveredWidth(): number {
    const stays = this.palette.isVisible() && !this.palette.autoClose;
    return this.getWidth() + (stays ? this.palette.getWidth() : 0);
  }

  protected showTitle(item: Selectable | null): void {
    if (!item) return;
    if ("head" in item) return this.title.replaceChildren((item as Selectable & WithHead).head);
    const name = document.createElement("span");
    name.textContent = item.getName();
    this.title.replaceChildren(...(item instanceof GroupItem ? [groupIcon(item.group)] : []), name);
  }
}
