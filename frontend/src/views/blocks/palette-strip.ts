/** The palette on a phone: a strip of groups at the bottom, and the open one in a sheet above it. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { icon } from "../../ui/icons";
import { PaletteToolbox } from "./palette-toolbox";
import { asTab, focusable } from "./patches";

/** A swipe down of this length closes the sheet, in CSS pixels. */
const SWIPE = 48;
/** The keys that open a group; the arrow leads into it, because it is above. */
const OPENING = new Set(["Enter", " ", "ArrowUp"]);

export class PaletteStrip extends PaletteToolbox {
  private readonly sheet = document.createElement("div");
  private readonly closeButton = document.createElement("button");
  private readonly bin = document.createElement("div");
  /** Whether a group may open now: unlike in the palette beside the program, the focus alone opens none. */
  private opening = false;
  private swipedFrom: number | null = null;
  private readonly closeOutside = (event: Event) => this.closeUnlessInside(event);

  override init(): void {
    super.init();
    this.buildSheet();
    this.buildBin();
    document.addEventListener("pointerdown", this.closeOutside, true);
  }

  override dispose(): void {
    document.removeEventListener("pointerdown", this.closeOutside, true);
    this.sheet.remove();
    super.dispose();
  }

  /** The sheet covers the program. */
  protected override get fits(): boolean {
    return false;
  }

  protected override addHead(): void {
    this.head.classList.add("lbSheetHead");
    this.closeButton.type = "button";
    this.closeButton.className = "lbPin";
    this.closeButton.ariaLabel = this.closeButton.title = t("page-blocks-close");
    this.closeButton.append(icon("close"));
    this.closeButton.addEventListener("click", () => this.closeSheet());
    this.head.append(this.title, this.closeButton);
  }

  protected override placeHead(): void {
    this.workspace_.getInjectionDiv().style.setProperty("--palette", "0px");
    const isOpen = this.palette.isVisible();
    this.head.hidden = !isOpen;
    this.head.style.top = `${this.palette.headTop}px`;
    this.sheet.ariaHidden = isOpen ? null : "true";
    this.sheet.classList.toggle("lbOpen", isOpen);
  }

  protected override showTitle(item: Blockly.ISelectableToolboxItem | null): void {
    super.showTitle(item);
    if (item) this.sheet.ariaLabel = t("page-blocks-sheet", { group: item.getName() });
  }

  override setSelectedItem(item: Blockly.IToolboxItem | null): void {
    if (!item || this.opening) super.setSelectedItem(item);
  }

  // A button in the head has the focus: the sheet stays open.
  override autoHide(onlyClosePopups: boolean): void {
    if (!this.head.contains(document.activeElement)) super.autoHide(onlyClosePopups);
  }

  // A finger on the strip may be about to scroll it: only a whole tap opens a group.
  protected override onClick_(): void {
    Blockly.Touch.clearTouchIdentifier();
  }

  private tap(event: PointerEvent): void {
    this.openBy(() => super.onClick_(event));
    this.enterSheet(this.palette.getWorkspace());
  }

  protected override onKeyDown_(event: KeyboardEvent): void {
    const item = asTab(Blockly.getFocusManager().getFocusedNode());
    if (!OPENING.has(event.key) || !item || !this.getToolboxItems().includes(item)) return super.onKeyDown_(event);
    event.preventDefault();
    event.stopPropagation();
    this.openBy(() => this.setSelectedItem(item));
    this.enterSheet(this.palette.getWorkspace().getNavigator().getFirstNode());
  }

  private openBy(act: () => void): void {
    this.opening = true;
    act();
    this.opening = false;
  }

  private buildSheet(): void {
    const blocks = this.workspace_.getInjectionDiv().querySelector(".blocklyToolboxFlyout")!;
    this.sheet.className = "lbSheet";
    this.sheet.setAttribute("role", "dialog");
    blocks.before(this.sheet);
    this.sheet.append(this.head, blocks);
    this.sheet.addEventListener("keydown", (event) => this.escape(event), true);
    this.head.addEventListener("pointerdown", (event) => this.beginSwipe(event));
    this.head.addEventListener("pointermove", (event) => this.swipe(event));
    for (const end of ["pointerup", "pointercancel"] as const) {
      this.head.addEventListener(end, (event) => this.endSwipe(event));
    }
    this.contentsDiv_?.addEventListener("click", (event) => this.tap(event as PointerEvent));
    this.placeHead();
  }

  /** What the strip says while a block is held over it. */
  private buildBin(): void {
    this.bin.className = "lbStripBin";
    this.bin.ariaHidden = "true";
    this.bin.append(icon("trash"), t("page-blocks-drop-to-delete"));
    this.HtmlDiv?.append(this.bin);
  }

  /** Move the focus to the search or to this part of the sheet: the whole for a finger, a block for a key. */
  private enterSheet(part: Blockly.IFocusableNode | null): void {
    if (!this.palette.isVisible()) return;
    const search = this.head.querySelector("input");
    if (search) search.focus();
    else if (part) Blockly.getFocusManager().focusNode(part);
  }

  /** Close the open group and return the focus to its button. */
  private closeSheet(): void {
    const item = this.getSelectedItem();
    this.setSelectedItem(null);
    if (item) Blockly.getFocusManager().focusNode(focusable(item));
  }

  private escape(event: KeyboardEvent): void {
    if (event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    this.closeSheet();
  }

  private closeUnlessInside({ target }: Event): void {
    if (!this.palette.isVisible() || !(target instanceof Element)) return;
    const isInside = this.sheet.contains(target) || this.HtmlDiv?.contains(target);
    // The editors of fields are outside the sheet.
    const isEditor = target.closest(".blocklyWidgetDiv, .blocklyDropDownDiv, dialog") !== null;
    if (!isInside && !isEditor) this.setSelectedItem(null);
  }

  private beginSwipe(event: PointerEvent): void {
    if ((event.target as Element).closest("button, input")) return;
    this.swipedFrom = event.clientY;
    this.head.setPointerCapture(event.pointerId);
  }

  private swipe({ clientY }: PointerEvent): void {
    if (this.swipedFrom !== null) this.moveSheet(Math.max(0, clientY - this.swipedFrom));
  }

  private endSwipe({ type, clientY }: PointerEvent): void {
    const length = this.swipedFrom === null ? 0 : clientY - this.swipedFrom;
    this.swipedFrom = null;
    this.moveSheet(0);
    if (type === "pointerup" && length >= SWIPE) this.closeSheet();
  }

  private moveSheet(down: number): void {
    this.sheet.style.setProperty("--swiped", `${down}px`);
  }
}
