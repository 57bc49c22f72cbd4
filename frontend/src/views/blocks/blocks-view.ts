/** The program as blocks. */

import { computed, effect, type ReadonlySignal, untracked } from "@preact/signals";
import { language, t } from "../../i18n";
import type { Context } from "../../model/context";
import { hasGame } from "../../model/games";
import type { OwnBlock } from "../../model/own-blocks";
import type { Stage, ThemeName } from "../../model/preferences";
import { preferences, theme } from "../../model/preferences";
import { plainTitle, servingWords } from "../../model/robots";
import { valuesInWords } from "../../model/values-there";
import type { Zoom } from "../../model/views";
import type { BlockSet, Workspace } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import { room } from "../../ui/screen";
import "./block-fields.css";
import "./blocks.css";
import { Cleanup } from "../../ui/cleanup";
import type { BlockActions, OfferedRobot } from "./actions";
import { BlockEditor } from "./editor";
import { usesGame } from "./games";
import type { Palette } from "./palette";
import { fetchPalette, installPalette } from "./palette";
import { prepare } from "./prepare";
import { blocksOf } from "./shown";

export interface BlocksIsland extends Island {
  focus(): void;
  /** Scroll to a block and highlight it. */
  reveal(block: string): void;
  describeStep(block: string): string;
  resize(): void;
  /** Show help on what has the focus; return whether there is any. */
  explain(): boolean;
  /** Obey a key that was pressed outside of it; return whether it did. */
  press(event: KeyboardEvent): boolean;
  /** Enlarge or shrink the program, or show it in its usual size. */
  zoom(change: Zoom): void;
  /** A block that the program defines, by its definition. */
  ownBlock(definition: string): OwnBlock | null;
  /** Change the program, as one edit by the user. */
  change(change: (program: Workspace) => Workspace): void;
  /** Move the focus to a block, in sight. */
  enter(block: string): void;
}

/** Create the blocks view; it fills `dom` once that is in the page and the palette has loaded. */
export function createBlocks(context: Context): BlocksIsland {
  prepare();
  return new Blocks(context);
}

function gamesOf({ running, program }: Context): ReadonlySignal<boolean> {
  return computed(() => hasGame(running.scene.value?.world) || usesGame(program.state.value.workspace));
}

/** The view scrolls to the running block at most this often, in ms. */
const FOLLOWING = 400;

class Blocks implements BlocksIsland {
  readonly dom = document.createElement("div");
  private editor: BlockEditor | null = null;
  private palette: Palette | null = null;
  /** Counts requests, so that older answers are ignored. */
  private asked = 0;
  private followed = 0;
  /** The program shown last; it is older than the blocks while edits are on their way to the server. */
  private shown: Workspace | null = null;
  private readonly cleanup: Cleanup;
  /** Whether the world or the program has a game. */
  private readonly inGame: ReadonlySignal<boolean>;

  constructor(private readonly context: Context) {
    this.dom.className = "blocks";
    this.dom.setAttribute("role", "group");
    this.inGame = gamesOf(context);
    const watcher = new ResizeObserver(() => this.resize());
    watcher.observe(this.dom);
    this.cleanup = new Cleanup(
      () => watcher.disconnect(),
      effect(() => this.dom.setAttribute("aria-label", t("page-blocks-label"))),
      effect(() => void this.load(language.value)),
      context.connection.on("PaletteChanged", () => void this.load(language.peek())),
      effect(() => this.showCustomBlocks()),
      effect(() => this.showRobot()),
      effect(() => this.showStage(preferences.value.stage)),
      effect(() => this.showBlocks(context.shownBlocks.value, this.inGame.value)),
      effect(() => this.showTheme(theme.value)),
      effect(() => this.arrange(room.value === "narrow")),
      effect(() => this.showAccess(context.program.readOnly.value !== null)),
      effect(() => this.showProgram()),
      effect(() => this.showProblems()),
      effect(() => this.showBreakpoints()),
      effect(() => this.showRunning()),
      effect(() => this.showValues()),
      effect(() => this.showNoted()),
    );
  }

  destroy(): void {
    this.cleanup.dispose();
    this.close();
    this.editor = null;
    this.asked += 1;
  }

  focus(): void {
    this.editor?.focus();
  }

  reveal(block: string): void {
    if (this.isShown) this.editor?.reveal(block);
  }

  describeStep(block: string): string {
    return this.editor?.describeStep(block) ?? "";
  }

  explain(): boolean {
    return this.editor?.explain() ?? false;
  }

  press(event: KeyboardEvent): boolean {
    return this.editor?.press(event) ?? false;
  }

  ownBlock(definition: string): OwnBlock | null {
    return this.editor?.ownBlock(definition) ?? null;
  }

  change(change: (program: Workspace) => Workspace): void {
    const { editor } = this;
    if (!editor) return;
    editor.change(change);
    this.edited();
  }

  enter(block: string): void {
    this.editor?.enter(block);
  }

  zoom(change: Zoom): void {
    this.editor?.zoom(change);
  }

  resize(): void {
    if (!this.isShown) return;
    if (this.editor) this.editor.resize();
    else this.open();
    this.showAll();
  }

  private get isShown(): boolean {
    return this.dom.clientWidth > 0 && this.dom.clientHeight > 0;
  }

  private async load(code: string): Promise<void> {
    this.asked += 1;
    const { asked } = this;
    try {
      const palette = await fetchPalette(code);
      this.whenReported(() => {
        // The user may have chosen a different language or left the page meanwhile.
        if (this.asked === asked) this.install(palette);
      });
    } catch (error) {
      if (this.asked === asked) this.fail(error);
    }
  }

  private whenReported(act: () => void): void {
    if (this.editor) this.editor.whenReported(act);
    else act();
  }

  private fail(error: unknown): void {
    console.error(error);
    if (!this.editor) this.dom.textContent = t("page-blocks-failed");
  }

  private install(palette: Palette): void {
    this.palette = palette;
    installPalette(palette);
    if (this.isShown) this.open();
  }

  private open(): void {
    if (!this.palette) return;
    const view = this.editor?.view;
    if (!view) this.shown = null;
    this.close();
    this.dom.textContent = "";
    const compact = room.peek() === "narrow";
    this.editor = new BlockEditor(
      this.dom,
      this.palette,
      theme.peek(),
      this.actions(),
      compact,
      () => this.edited(),
      () => this.showMarks(),
    );
    if (view) this.editor.adopt(view);
    this.showAccess(this.context.program.readOnly.peek() !== null);
    this.showAll();
  }

  /** Close the editor; its edits are sent first, since they can't be read from it any more. */
  private close(): void {
    this.context.program.flush();
    this.editor?.destroy();
  }

  /** A palette cannot be moved: another arrangement needs another editor. */
  private arrange(compact: boolean): void {
    untracked(() => {
      this.whenReported(() => {
        if (this.editor && this.editor.isCompact !== compact) this.open();
      });
    });
  }

  private actions(): BlockActions {
    const { program, running } = this.context;
    return {
      undo: () => program.undo(),
      redo: () => program.redo(),
      canUndo: () => program.state.peek().canUndo,
      canRedo: () => program.state.peek().canRedo,
      toggleBreakpoint: (block) => running.toggleBreakpoint(block),
      hasBreakpoint: (block) => running.breakpoints.peek().has(block),
      hasRun: () => !!running.timeline.peek()?.end,
      goToRun: (by, block) => this.context.lookingBack.toRun(by, block),
      askWhy: (block) => this.context.askingWhy.aboutBlock(block),
      draw: (block) => this.editor?.draw(block),
      show: (block) => this.context.reveal(block),
      copied: (block) => void this.copyText(block),
      select: (block) => this.context.select(block),
      shownBlocks: () => this.context.shownBlocks.peek(),
      robot: () => this.robot,
      inGame: () => this.inGame.peek(),
      customBlocks: () => new Set(this.context.customBlocks.peek()?.flatMap(({ blocks }) => blocks)),
      tagNames: () => Object.keys(this.context.tagNames.peek()),
      offered: (type) => this.palette?.toolbox.contents.flatMap(blocksOf).find((one) => one.type === type),
      makeBlock: () => this.context.makeBlock(""),
      changeBlock: (definition) => this.context.makeBlock(definition),
      openExample: (program) => this.context.openExample(program),
      listCustomBlocks: () => this.context.listCustomBlocks(),
      newCustomBlock: () => this.context.editCustomBlock(""),
      editCustomBlock: (skill) => this.editCustomBlock(skill),
    };
  }

  private async copyText(block: string): Promise<void> {
    const { program } = this.context;
    const text = program.copied.keep(program.state.peek(), block);
    try {
      if (text !== null) await navigator.clipboard.writeText(text);
    } catch {
      // Over plain HTTP from another computer there is no clipboard: it can only be pasted as a block.
    }
  }

  private editCustomBlock(skill: string): void {
    const found = this.context.customBlocks.peek()?.find(({ blocks }) => blocks.includes(skill));
    if (found) this.context.editCustomBlock(found.name);
  }

  private edited(): void {
    const { editor } = this;
    if (editor) this.context.program.editedBlocks(() => editor.read());
  }

  private showAll(): void {
    untracked(() => this.showProgram());
    this.showMarks();
  }

  private showProgram(): void {
    const { workspace, stale } = this.context.program.state.value;
    this.dom.classList.toggle("stale", stale.includes("blocks"));
    if (!this.editor || !this.isShown) return;
    if (workspace !== this.shown) this.editor.show(workspace);
    this.shown = workspace;
    this.editor.whenLoaded(() => this.showMarks());
  }

  private showMarks(): void {
    untracked(() => {
      this.showProblems();
      this.showBreakpoints();
      this.showRunning();
      this.showValues();
      this.showNoted();
    });
  }

  private showProblems(): void {
    const problems = [...this.context.program.state.value.problems, ...this.context.runError.value];
    this.editor?.marks.showProblems(problems);
  }

  // Read the signals before the editor exists: an effect depends only on what it has read.
  private showTheme(name: ThemeName): void {
    this.editor?.setTheme(name);
  }

  private showAccess(readOnly: boolean): void {
    this.editor?.setReadOnly(readOnly);
  }

  private showBlocks(set: BlockSet, inGame: boolean): void {
    this.editor?.whenStill(() => this.editor?.showBlocks(set, inGame));
  }

  private showCustomBlocks(): void {
    if (this.context.customBlocks.value) this.editor?.refreshPalette();
  }

  private get robot(): OfferedRobot {
    const robots = this.context.robots.value;
    const chosen = robots.find(({ name }) => name === this.context.running.robot.value);
    const simulated = robots.filter((one) => one.simulated);
    return {
      all: simulated.map((one) => ({ title: plainTitle(one), lacks: one.lacks ?? [] })),
      title: chosen ? plainTitle(chosen) : "",
      lacks: new Set(chosen?.lacks ?? []),
      serving: (needs) => (chosen ? servingWords(chosen, needs) : ""),
    };
  }

  private showRobot(): void {
    if (this.robot.title) this.editor?.refreshPalette();
  }

  /** The palette offers more to those who know more. */
  private showStage(stage: Stage): void {
    if (stage) this.editor?.refreshPalette();
  }

  private showBreakpoints(): void {
    const blocks = this.context.running.breakpoints.value;
    this.editor?.marks.showBreakpoints(blocks);
  }

  private showRunning(): void {
    const [block, { state }] = [this.context.running.block.value, this.context.running.state.value];
    const isHeld = state === "held";
    if (block && isHeld) this.editor?.drawBlock(block);
    const shown = this.editor?.marks.showRunning(block);
    if (shown) this.follow(shown, isHeld);
  }

  private showValues(): void {
    const texts = valuesInWords(this.context.running.values.value);
    this.editor?.marks.showValues(texts);
  }

  private showNoted(): void {
    const block = this.context.noted.value;
    this.editor?.marks.showNoted(block);
  }

  private follow(block: Parameters<BlockEditor["follow"]>[0], atOnce: boolean): void {
    const now = performance.now();
    if (!atOnce && now - this.followed < FOLLOWING) return;
    this.followed = now;
    this.editor?.follow(block);
  }
}
