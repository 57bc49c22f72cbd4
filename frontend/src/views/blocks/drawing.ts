/** A picture of some blocks, drawn by Blockly. */

import { effect } from "@preact/signals";
import * as Blockly from "blockly/core";

import { language } from "../../i18n";
import { theme } from "../../model/preferences";
import type { Workspace } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { Checker } from "./checker";
import { MEDIA } from "./media";
import { fetchPalette, installPalette, type Palette } from "./palette";
import { Sync } from "./sync";
import { themeOf } from "./themes";
import "./block-fields.css";
import "./drawing.css";

type State = Blockly.serialization.blocks.State;

const MARGIN = 6;
const LARGEST_SCALE = 0.72;
/** The language whose blocks Blockly has learned for drawings. */
let installed: { readonly language: string; readonly done: Promise<Palette> } | null = null;

export class Drawing implements Island {
  private readonly host = document.createElement("div");
  readonly dom = pictureOf(this.host);
  private workspace: Blockly.WorkspaceSvg | null = null;
  private isGone = false;
  private marked: string | null = null;
  private readonly cleanup: Cleanup;

  constructor(
    /** A program, or a block as the palette has it. */
    private readonly blocks: Workspace | State,
    text: string,
  ) {
    this.dom.classList.add("block-drawing");
    this.dom.ariaLabel = text;
    this.cleanup = new Cleanup(
      followTheme(() => this.workspace),
      effect(() => void this.draw(language.value)),
    );
  }

  destroy(): void {
    this.isGone = true;
    this.cleanup.dispose();
    this.workspace?.dispose();
    this.dom.remove();
  }

  /** Mark a block as running, or none. */
  mark(id: string | null): void {
    if (id === this.marked) return;
    this.find(this.marked)?.removeClass("lbRunning");
    this.find(id)?.addClass("lbRunning");
    this.marked = id;
  }

  /** The innermost statement that is drawn at a place of the window; null without one. */
  statementAt(x: number, y: number): string | null {
    const blocks = this.workspace?.getAllBlocks(true).filter((block) => !block.outputConnection) ?? [];
    const there = blocks.filter((block) => covers((block as Blockly.BlockSvg).pathObject.svgPath, x, y));
    return there.at(-1)?.id ?? null;
  }

  private find(id: string | null): Blockly.BlockSvg | null {
    return (id && this.workspace?.getBlockById(id)) || null;
  }

  /** Blockly can only draw once the element has a size. */
  resize(): void {
    if (this.workspace) this.fit(this.workspace);
    else void this.draw(language.peek());
  }

  private async draw(code: string): Promise<void> {
    await learnPalette(code);
    if (this.isGone || !this.dom.clientWidth || code !== language.peek()) return;
    this.workspace?.dispose();
    this.workspace = Blockly.inject(this.host, pictureOptions());
    this.fill(this.workspace);
    this.find(this.marked)?.addClass("lbRunning");
    Blockly.renderManagement.triggerQueuedRenders(this.workspace);
    this.fit(this.workspace);
  }

  private fill(workspace: Blockly.WorkspaceSvg): void {
    if ("stacks" in this.blocks) new Sync(workspace, workspace.connectionChecker as Checker).show(this.blocks);
    else Blockly.serialization.blocks.append(this.blocks, workspace);
  }

  private fit(workspace: Blockly.WorkspaceSvg): void {
    const { left, top, right, bottom } = workspace.getBlocksBoundingBox();
    const [width, height] = [right - left, bottom - top];
    const scale = Math.min(LARGEST_SCALE, this.dom.clientWidth / (width + 2 * MARGIN));
    this.host.style.width = `${scale * (width + 2 * MARGIN)}px`;
    this.host.style.height = `${scale * (height + 2 * MARGIN)}px`;
    workspace.setScale(scale);
    Blockly.svgResize(workspace);
    // Blockly puts it there again when the window changes its size.
    [workspace.scrollX, workspace.scrollY] = [(MARGIN - left) * scale, (MARGIN - top) * scale];
    workspace.translate(workspace.scrollX, workspace.scrollY);
  }
}

function covers(path: SVGElement, x: number, y: number): boolean {
  const { left, right, top, bottom } = path.getBoundingClientRect();
  return left <= x && x <= right && top <= y && y <= bottom;
}

/** Teach Blockly the blocks of a language; the view of the blocks, if it is shown, has the same. */
export function learnPalette(code: string): Promise<Palette> {
  if (installed?.language !== code) installed = { language: code, done: learn(code) };
  return installed.done;
}

async function learn(code: string): Promise<Palette> {
  const palette = await fetchPalette(code);
  installPalette(palette);
  return palette;
}

/** The picture that Blockly draws in a host. */
export function pictureOf(host: HTMLElement): HTMLElement {
  const dom = document.createElement("div");
  dom.className = "blocks";
  dom.setAttribute("role", "img");
  // It is a picture: nothing in it takes the focus or a click.
  host.inert = true;
  dom.append(host);
  return dom;
}

/** Keep a picture in the colours that the user has chosen; the answer ends that. */
export function followTheme(picture: () => Blockly.WorkspaceSvg | null): () => void {
  return effect(() => {
    // Read before there is a picture, so that a later one follows too.
    const chosen = themeOf(theme.value);
    picture()?.setTheme(chosen);
  });
}

/** A picture looks like the blocks in the program. */
export function pictureOptions(): Blockly.BlocklyOptions {
  return {
    renderer: "zelos",
    theme: themeOf(theme.peek()),
    media: MEDIA,
    readOnly: true,
    sounds: false,
    zoom: { maxScale: 1, minScale: 0.1 },
    move: { scrollbars: false, drag: false, wheel: false },
    plugins: { connectionChecker: Checker },
  };
}
