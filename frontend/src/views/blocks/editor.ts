/** Blockly's workspace on the page, in one language. */

import { ScrollBlockDragger, ScrollMetricsManager, ScrollOptions } from "@blockly/plugin-scroll-options";
import * as Blockly from "blockly/core";
import type { ThemeName } from "../../model/preferences";
import type { BlockSet, Workspace } from "../../protocol/messages";
import { type Actions, setActions } from "./actions";
import { registerCategories } from "./categories";
import { Checker } from "./checker";
import { Loading } from "./loading";
import { Loose } from "./loose";
import { Marks, visible } from "./marks";
import { MEDIA } from "./media";
import type { Palette } from "./palette";
import { ProgramSearch } from "./search";
import { limitTabs, toolboxOf } from "./shown";
import { Sight } from "./sight";
import { Sync } from "./sync";
import { themeOf } from "./themes";

/** The state that an editor passes to the editor that replaces it in a different language. */
interface View {
  readonly workspace: Workspace;
  /** The palette's open tab, by its name. */
  readonly tab: string;
  readonly focused: "palette" | "program" | null;
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}

/** A workspace and its content; an edit by the user calls `edited`. */
export class Editor {
  readonly marks: Marks;
  private readonly workspace: Blockly.WorkspaceSvg;
  private readonly sync: Sync;
  private readonly sight: Sight;
  private readonly loose: Loose;
  private readonly search: ProgramSearch;
  private readonly loading: Loading;

  constructor(
    host: HTMLElement,
    private readonly palette: Palette,
    theme: ThemeName,
    actions: Actions,
    private readonly edited: () => void,
  ) {
    this.workspace = Blockly.inject(host, options(palette, theme, actions.shownBlocks()));
    // The server handles undo for all views.
    this.workspace.MAX_UNDO = 0;
    this.sync = new Sync(this.workspace, this.workspace.connectionChecker as Checker);
    this.sight = new Sight(this.workspace);
    this.loose = new Loose(this.workspace);
    this.marks = new Marks(this.workspace, (block) => actions.toggleBreakpoint(block));
    this.search = new ProgramSearch(this.workspace);
    this.search.init();
    this.loading = new Loading(host, this.workspace, () => this.addNext());
    new ScrollOptions(this.workspace).init();
    registerCategories(this.workspace);
    limitTabs(this.workspace, palette, () => actions.shownBlocks());
    setActions(this.workspace, actions);
    this.workspace.addChangeListener((event) => this.hear(event));
  }

  destroy(): void {
    this.loading.destroy();
    this.sight.destroy();
    this.search.dispose();
    this.workspace.dispose();
  }

  /**
   * Show a program, unless a drag is in progress: the drag's result is sent when it ends, and the
   * reply updates the view. Blocks of a large program are added one after the other, so that the
   * page stays usable.
   */
  show(wanted: Workspace): void {
    if (this.workspace.isDragging() || !this.sync.show(wanted)) return;
    if (this.sync.isLoading) this.loading.begin();
    this.whenLoaded(() => this.changed());
  }

  /** Call a function as soon as all blocks are shown. */
  whenLoaded(act: () => void): void {
    if (this.loading.isOn) this.loading.whenDone(act);
    else act();
  }

  /** Show only the blocks of a set in the palette. */
  showBlocks(set: BlockSet): void {
    this.workspace.updateToolbox(toolboxOf(this.palette, set));
  }

  /** Refresh the palette's open tab. */
  refreshPalette(): void {
    this.workspace.refreshToolboxSelection();
  }

  /** Call a function as soon as nothing is being dragged. */
  whenStill(act: () => void): void {
    if (!this.workspace.isDragging()) return act();
    const dropped = ({ type }: Blockly.Events.Abstract) => {
      if (type !== Blockly.Events.BLOCK_DRAG || this.workspace.isDragging()) return;
      this.workspace.removeChangeListener(dropped);
      act();
    };
    this.workspace.addChangeListener(dropped);
  }

  read(): Workspace {
    return this.sync.read();
  }

  setTheme(theme: ThemeName): void {
    this.workspace.setTheme(themeOf(theme));
  }

  setReadOnly(on: boolean): void {
    this.workspace.setIsReadOnly(on);
  }

  resize(): void {
    Blockly.svgResize(this.workspace);
  }

  focus(): void {
    Blockly.getFocusManager().focusTree(this.workspace);
  }

  /** Scroll to a block and highlight it, without moving the focus. */
  reveal(id: string): void {
    this.whenLoaded(() => this.revealNow(id));
  }

  private revealNow(id: string): void {
    const block = visible(this.workspace.getBlockById(id));
    if (!block) return;
    this.scrollTo(block);
    block.removeClass("lbRevealed");
    block.addClass("lbRevealed");
    block.getSvgRoot().addEventListener("animationend", () => block.removeClass("lbRevealed"), { once: true });
  }

  scrollTo(block: Blockly.BlockSvg): void {
    this.workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren());
  }

  /** The state for a successor. */
  get view(): View {
    const { scale, scrollX, scrollY } = this.workspace;
    return { workspace: this.read(), tab: this.openTab, focused: this.focused, scale, x: scrollX, y: scrollY };
  }

  takeOver({ workspace, tab, focused, scale, x, y }: View): void {
    this.show(workspace);
    this.workspace.setScale(scale);
    this.workspace.scroll(x, y);
    const opened = this.open(tab);
    this.whenLoaded(() => this.focusOn(focused, opened));
  }

  private focusOn(focused: View["focused"], opened: Blockly.ToolboxCategory | null): void {
    if (focused === "program") this.focus();
    if (focused === "palette" && opened) Blockly.getFocusManager().focusNode(opened);
    else if (focused === "palette" && this.toolbox) Blockly.getFocusManager().focusTree(this.toolbox);
  }

  private get focused(): View["focused"] {
    const { activeElement } = document;
    if (!this.workspace.getInjectionDiv().contains(activeElement)) return null;
    return activeElement?.closest(".blocklyToolbox, .blocklyFlyout") ? "palette" : "program";
  }

  private get openTab(): string {
    const item = this.toolbox?.getSelectedItem();
    return item instanceof Blockly.ToolboxCategory ? item.getName() : "";
  }

  private open(tab: string): Blockly.ToolboxCategory | null {
    const tabs = (this.toolbox?.getToolboxItems() ?? []).filter((item) => item instanceof Blockly.ToolboxCategory);
    const found = tabs.find((item) => tab && item.getName() === tab) ?? null;
    if (found) this.toolbox?.setSelectedItem(found);
    return found;
  }

  private get toolbox(): Blockly.Toolbox | null {
    return this.workspace.getToolbox() as Blockly.Toolbox | null;
  }

  private hear(event: Blockly.Events.Abstract): void {
    if (!event.isUiEvent || event.type === Blockly.Events.VIEWPORT_CHANGE) this.sight.look();
    const dropped = event.type === Blockly.Events.BLOCK_DRAG && !(event as Blockly.Events.BlockDrag).isStart;
    if (!dropped && (event.isUiEvent || this.workspace.isDragging())) return;
    this.loose.mark();
    // An edit just before the loading is read when all blocks are there.
    this.whenLoaded(() => this.edited());
  }

  private changed(): void {
    this.loose.mark();
    this.workspace.refreshToolboxSelection();
    this.sight.look();
  }

  /** Add the next blocks; return whether there are more. */
  private addNext(): boolean {
    for (const stack of this.sync.addNext()) this.sight.mark(stack.getDescendants(false));
    return this.sync.isLoading;
  }
}

function options(palette: Palette, theme: ThemeName, set: BlockSet): Blockly.BlocklyOptions {
  return {
    renderer: "zelos",
    theme: themeOf(theme),
    media: MEDIA,
    toolbox: toolboxOf(palette, set),
    oneBasedIndex: false,
    trashcan: true,
    sounds: false,
    grid: { spacing: 24, length: 2, colour: "var(--border)", snap: false },
    zoom: { controls: true, wheel: false, pinch: true, startScale: 0.8, maxScale: 2.5, minScale: 0.25 },
    move: { scrollbars: true, drag: true, wheel: true },
    plugins: {
      blockDragger: ScrollBlockDragger,
      metricsManager: ScrollMetricsManager,
      connectionChecker: Checker,
    },
  };
}
