/** Blockly's workspace on the page, in one language. */

import { ScrollMetricsManager, ScrollOptions } from "@blockly/plugin-scroll-options";
import * as Blockly from "blockly/core";
import type { OwnBlock } from "../../model/own-blocks";
import type { ThemeName } from "../../model/preferences";
import type { Zoom } from "../../model/views";
import type { BlockSet, Workspace } from "../../protocol/messages";
import { actionsOf, type BlockActions, setActions } from "./actions";
import { registerCategories } from "./categories";
import { Checker } from "./checker";
import { COMPACT } from "./compact";
import { Dragger, EDGE } from "./dragger";
import { Fit } from "./fit";
import { pieceWith, type Rest } from "./folds";
import { sidesToFollow } from "./follow";
import { Invitation } from "./invitation";
import { Loading } from "./loading";
import { Loose } from "./loose";
import { Marks, visible } from "./marks";
import { MEDIA } from "./media";
import { changeOwnBlock, explainFocused } from "./menus";
import { isDefinition, ownBlockOf } from "./own-blocks";
import type { Palette } from "./palette";
import { PaletteFlyout } from "./palette-flyout";
import { PaletteSheet } from "./palette-sheet";
import { PaletteStrip } from "./palette-strip";
import { PaletteToolbox } from "./palette-toolbox";
import { bottomOf, covered, placedBelow } from "./places";
import { Reach } from "./reach";
import { restIn } from "./rest-block";
import { type Hidden, ProgramSearch } from "./search";
import { SharedClipboard } from "./shared-clipboard";
import { limitTabs, toolboxOf } from "./shown";
import { Sight } from "./sight";
import { Sync } from "./sync";
import { themeOf } from "./themes";
import { drawBin } from "./tools";
import { showUsedNames } from "./when-block";
import { Words, wordsOf } from "./words";

/** The usual size of the blocks, and the room around them in units of the workspace. */
const SCALE = 0.85;
const MARGIN = 40;

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

/**
 * A workspace and its content; an edit by the user calls `edited`.
 *
 * A compact one is for a phone.
 */
export class BlockEditor {
  readonly marks: Marks;
  private readonly workspace: Blockly.WorkspaceSvg;
  private readonly sync: Sync;
  private readonly sight: Sight;
  private readonly loose: Loose;
  private readonly search: ProgramSearch;
  private readonly loading: Loading;
  private readonly reach: Reach;
  private readonly words = new Words();
  private readonly invitation: Invitation;
  private readonly clipboard: SharedClipboard;
  private readonly fit: Fit;

  constructor(
    private readonly host: HTMLElement,
    private readonly palette: Palette,
    theme: ThemeName,
    actions: BlockActions,
    compact: boolean,
    private readonly edited: () => void,
    /** Called when blocks have been drawn that were not. */
    drawn: () => void,
  ) {
    const usual = options(theme, toolboxOf(palette, actions.shownBlocks(), actions.inGame()));
    this.workspace = Blockly.inject(host, compact ? compacted(usual) : usual);
    drawBin(this.workspace);
    // The server handles undo for all views.
    this.workspace.MAX_UNDO = 0;
    this.sync = new Sync(this.workspace, this.workspace.connectionChecker as Checker);
    this.sight = new Sight(this.workspace);
    this.loose = new Loose(this.workspace);
    this.marks = new Marks(this.workspace, {
      toggleBreakpoint: (block) => actions.toggleBreakpoint(block),
      placeholderOf: (block) => this.sync.placeholderOf(block),
    });
    this.reach = new Reach(this.workspace, this.sync, () => {
      this.changed();
      drawn();
    });
    this.search = new ProgramSearch(this.workspace, this.hidden());
    this.search.init();
    this.invitation = new Invitation(this.workspace);
    this.clipboard = new SharedClipboard(this.workspace);
    this.fit = new Fit(host, this.workspace, SCALE);
    this.loading = new Loading(host, this.workspace, () => this.addNext());
    new ScrollOptions(this.workspace).init({ edgeScrollOptions: EDGE });
    registerCategories(this.workspace);
    limitTabs(this.workspace, palette, () => actions.shownBlocks());
    setActions(this.workspace, actions);
    this.workspace.addChangeListener((event) => this.receive(event));
    host.addEventListener("dblclick", this.openOwn);
    this.toolbox?.begin();
  }

  destroy(): void {
    this.host.removeEventListener("dblclick", this.openOwn);
    this.fit.destroy();
    this.loading.destroy();
    this.invitation.destroy();
    this.clipboard.destroy();
    this.sight.destroy();
    this.reach.destroy();
    this.words.destroy();
    this.search.dispose();
    this.workspace.dispose();
  }

  /**
   * Show a program, unless a drag is in progress: the drag's result is sent when it ends, and the
   * reply updates the view. Blocks of a large program are added one after the other, so that the
   * page stays usable.
   */
  show(wanted: Workspace): void {
    this.fit.remember();
    if (this.workspace.isDragging() || !this.sync.show(wanted)) return;
    if (this.sync.isLoading) this.loading.begin();
    this.whenLoaded(() => this.changed());
  }

  /** Change the program; what is new is below the rest, and nothing else moves. */
  change(change: (program: Workspace) => Workspace): void {
    this.show(placedBelow(change(this.read()), bottomOf(covered(this.workspace).values())));
  }

  /** Call a function as soon as all blocks are shown. */
  whenLoaded(act: () => void): void {
    if (this.loading.isOn) this.loading.whenDone(act);
    else act();
  }

  /** Show only the blocks of a set in the palette. */
  showBlocks(set: BlockSet, inGame: boolean): void {
    this.workspace.updateToolbox(toolboxOf(this.palette, set, inGame));
    this.toolbox?.begin();
  }

  /** Refresh the palette's open tab. */
  refreshPalette(): void {
    this.workspace.refreshToolboxSelection();
  }

  /** Call a function as soon as nothing is being dragged and `edited` has been called for every edit. */
  whenReported(act: () => void): void {
    // Blockly reports edits after the next frame.
    this.whenStill(() => requestAnimationFrame(() => setTimeout(act)));
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

  get isCompact(): boolean {
    return this.workspace.horizontalLayout;
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

  /** Adapt to the size of the view; the program stays where it is, also while a block is dragged beyond its edges. */
  resize(): void {
    this.whenStill(() => this.resizeNow());
  }

  private resizeNow(): void {
    const { scrollX, scrollY } = this.workspace;
    this.toolbox?.fit();
    Blockly.svgResize(this.workspace);
    if (this.workspace.scrollX !== scrollX || this.workspace.scrollY !== scrollY)
      this.workspace.scroll(scrollX, scrollY);
    this.fit.look();
  }

  /** A block of the program as its dialog shows it. */
  ownBlock(definition: string): OwnBlock | null {
    const block = this.workspace.getBlockById(definition);
    return block && isDefinition(block) ? ownBlockOf(block) : null;
  }

  /** Move the focus to a block, in sight. */
  enter(id: string): void {
    this.whenLoaded(() => {
      this.revealNow(id);
      const block = this.workspace.getBlockById(id);
      if (block) Blockly.getFocusManager().focusNode(block);
    });
  }

  private readonly openOwn = ({ target }: Event): void => {
    const id = (target as Element).closest("[data-id]")?.getAttribute("data-id");
    const block = id ? this.workspace.getBlockById(id) : null;
    if (block && !Blockly.WidgetDiv.isVisible() && changeOwnBlock(block)) this.workspace.hideChaff();
  };

  /** Show the help on the block with the focus; return whether there is one. */
  explain(): boolean {
    return this.focused !== null && explainFocused(this.workspace);
  }

  /** Obey a key that was pressed outside; inside, Blockly has done so already. */
  press(event: KeyboardEvent): boolean {
    if (this.workspace.getInjectionDiv().contains(event.target as Node)) return false;
    this.continueAtEnd();
    if (Blockly.ShortcutRegistry.registry.onKeyDown(this.workspace, event)) return true;
    const isSearch = event.ctrlKey || event.metaKey;
    if (isSearch) this.search.open();
    return isSearch;
  }

  /**
   * Focus the end of the main program if no block of the program has had the focus.
   * Blockly inserts at the block that had it last: without one, a block from the palette would stay loose.
   */
  private continueAtEnd(): void {
    if (Blockly.FocusableTreeTraverser.findFocusedNode(this.workspace) instanceof Blockly.BlockSvg) return;
    const [main] = this.workspace.getBlocksByType("lb_main");
    if (main) Blockly.getFocusManager().focusNode(endOf(main as Blockly.BlockSvg));
  }

  /** Change the size around the middle of the view; the usual size shows the program's upper left corner. */
  zoom(change: Zoom): void {
    if (change !== "reset") return this.workspace.zoomCenter(change === "in" ? 1 : -1);
    const { left, top } = this.workspace.getBlocksBoundingBox();
    this.workspace.setScale(SCALE);
    this.workspace.scroll((MARGIN - left) * SCALE, (MARGIN - top) * SCALE);
  }

  focus(): void {
    Blockly.getFocusManager().focusTree(this.workspace);
  }

  /** A statement as a sentence, without what is inside it. */
  describeStep(id: string): string {
    const block = this.workspace.getBlockById(id);
    if (block) return wordsOf(block);
    const hidden = this.sync.placeholderOf(id) && this.sync.hiddenBlocks().find((one) => one.id === id);
    return hidden ? this.words.of(hidden, this.sync.variables) : "";
  }

  /** Draw a block that is not drawn, and what is around it. */
  drawBlock(id: string): void {
    for (let rest = this.restFor(id); rest; rest = this.restFor(id)) {
      const first = pieceWith(id, rest)?.[0];
      if (first) this.reach.draw([first.id]);
    }
  }

  /** Draw the first statements that a placeholder hides. */
  draw(rest: string): void {
    const first = restIn(this.workspace.getBlockById(rest))?.pieces[0]?.[0];
    if (first) this.reach.draw([first.id]);
  }

  private restFor(id: string): Rest | null {
    return restIn(this.workspace.getBlockById(this.sync.placeholderOf(id) ?? ""));
  }

  /** Scroll to a block and highlight it, without moving the focus. */
  reveal(id: string): void {
    this.whenLoaded(() => this.revealNow(id));
  }

  private revealNow(id: string): void {
    this.drawBlock(id);
    const block = visible(this.workspace.getBlockById(id));
    if (!block) return;
    this.scrollTo(block);
    block.removeClass("lbRevealed");
    block.addClass("lbRevealed");
    block.getSvgRoot().addEventListener("animationend", () => block.removeClass("lbRevealed"), { once: true });
  }

  /** Scroll to a block if it is not in sight. */
  scrollTo(block: Blockly.BlockSvg): void {
    this.workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren());
  }

  /** Scroll up or down to the block that runs, and sideways only if nothing of it is in the view. */
  follow(block: Blockly.BlockSvg): void {
    const view = this.workspace.getMetricsManager().getViewMetrics(true);
    const { top, bottom, ...sides } = block.getBoundingRectangleWithoutChildren();
    const { left, right } = sidesToFollow(sides, view);
    this.workspace.scrollBoundsIntoView(new Blockly.utils.Rect(top, bottom, left, right));
  }

  /** The state for a successor. */
  get view(): View {
    const { scale, scrollX, scrollY } = this.workspace;
    return { workspace: this.read(), tab: this.openTab, focused: this.focused, scale, x: scrollX, y: scrollY };
  }

  adopt({ workspace, tab, focused, scale, x, y }: View): void {
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

  private get toolbox(): PaletteToolbox | null {
    return this.workspace.getToolbox() as PaletteToolbox | null;
  }

  private receive(event: Blockly.Events.Abstract): void {
    if (event.type === Blockly.Events.SELECTED) this.select((event as Blockly.Events.Selected).newElementId);
    if (!event.isUiEvent || event.type === Blockly.Events.VIEWPORT_CHANGE) this.look();
    const dropped = event.type === Blockly.Events.BLOCK_DRAG && !(event as Blockly.Events.BlockDrag).isStart;
    if (!dropped && (event.isUiEvent || this.workspace.isDragging())) return;
    this.mark();
    this.edited();
  }

  private mark(): void {
    this.loose.mark();
    showUsedNames(this.workspace);
  }

  private look(): void {
    this.sight.look();
    this.reach.look();
    this.invitation.update(this.loading.isOn);
  }

  /** What is not drawn, for the search. */
  private hidden(): Hidden {
    return {
      prepare: (done) => this.words.prepare(this.sync.hiddenBlocks(), this.sync.variables, done),
      find: (words) => this.sync.hiddenBlocks().filter((block) => this.words.has(block, words)),
      draw: ({ id }) => this.drawBlock(id),
    };
  }

  /** Report the selected statement; a value belongs to the statement around it. */
  private select(id: string | null | undefined): void {
    let block = id ? this.workspace.getBlockById(id) : null;
    while (block?.outputConnection) block = block.getParent();
    actionsOf(this.workspace)?.select(restIn(block)?.pieces[0]?.[0]?.id ?? block?.id ?? null);
  }

  private changed(): void {
    this.fit.look();
    this.mark();
    this.workspace.refreshToolboxSelection();
    this.look();
  }

  /** Add the next blocks; return whether there are more. */
  private addNext(): boolean {
    for (const stack of this.sync.addNext()) this.sight.mark(stack.getDescendants(false));
    return this.sync.isLoading;
  }
}

function options(theme: ThemeName, toolbox: Blockly.utils.toolbox.ToolboxInfo): Blockly.BlocklyOptions {
  return {
    renderer: "zelos",
    theme: themeOf(theme),
    media: MEDIA,
    toolbox,
    oneBasedIndex: false,
    trashcan: true,
    sounds: false,
    grid: { spacing: 24, length: 2, colour: "var(--dots)", snap: false },
    zoom: { controls: false, wheel: false, pinch: true, startScale: SCALE, maxScale: 2.5, minScale: 0.25 },
    move: { scrollbars: true, drag: true, wheel: true },
    plugins: {
      blockDragger: Dragger,
      metricsManager: ScrollMetricsManager,
      connectionChecker: Checker,
      toolbox: PaletteToolbox,
      flyoutsVerticalToolbox: PaletteFlyout,
    },
  };
}

/** On a phone the groups are a strip at the bottom, which is the bin, too; two fingers zoom. */
function compacted(usual: Blockly.BlocklyOptions): Blockly.BlocklyOptions {
  return {
    ...usual,
    renderer: COMPACT,
    horizontalLayout: true,
    toolboxPosition: "end",
    trashcan: false,
    plugins: { ...usual.plugins, toolbox: PaletteStrip, flyoutsHorizontalToolbox: PaletteSheet },
  };
}

/** The last statement in a hat; the hat if it is empty. */
function endOf(hat: Blockly.BlockSvg): Blockly.BlockSvg {
  let last = hat.getInputTargetBlock("DO") as Blockly.BlockSvg | null;
  while (last?.getNextBlock()) last = last.getNextBlock();
  return last ?? hat;
}
