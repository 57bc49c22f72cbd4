/** A picture of a program as SVG, in any language and theme of the page. */

import * as Blockly from "blockly/core";

import { language } from "../../i18n";
import { type ThemeName, theme } from "../../model/preferences";
import type { Workspace } from "../../protocol/messages";
import type { Checker } from "./checker";
import { pictureOf, pictureOptions } from "./drawing";
import { fetchPalette, installPalette } from "./palette";
import { complete, type PortablePicture, portable } from "./portable-svg";
import { Sync } from "./sync";
import { themeOf } from "./themes";

export interface PictureChoices {
  readonly language: string;
  readonly theme: ThemeName;
  /** What the picture shows, for those who can't see it. */
  readonly text: string;
  /** The block that is drawn alone, with what is inside it; null for the whole program. */
  readonly only: string | null;
}

/** Draw a program; Blockly must be prepared. */
export async function drawProgram(program: Workspace, choices: PictureChoices): Promise<PortablePicture> {
  const own = language.peek();
  const [shown, back] = await Promise.all([
    fetchPalette(choices.language),
    choices.language === own ? null : fetchPalette(own),
  ]);
  installPalette(shown);
  try {
    // Blockly and the style sheets have one language and one theme: nothing else runs until the page has its own again.
    return complete(inTheme(choices.theme, () => drawNow(program, choices)));
  } finally {
    if (back) installPalette(back);
  }
}

function inTheme<Result>(name: ThemeName, draw: () => Result): Result {
  const { dataset } = document.documentElement;
  const before = dataset.theme ?? theme.peek();
  dataset.theme = name;
  try {
    return draw();
  } finally {
    dataset.theme = before;
  }
}

function drawNow(program: Workspace, { theme: name, text, only }: PictureChoices): PortablePicture {
  const host = document.createElement("div");
  const place = pictureOf(host);
  place.classList.add("block-drawing", "program-picture");
  document.body.append(place);
  const workspace = Blockly.inject(host, { ...pictureOptions(), theme: themeOf(name) });
  try {
    drawAll(workspace, program);
    if (only) keepOnly(workspace, only);
    Blockly.renderManagement.triggerQueuedRenders(workspace);
    // Light blocks are for paper and documents, which have a ground of their own.
    const ground = name === "light" ? null : getComputedStyle(place).backgroundColor;
    return portable(workspace.getCanvas(), workspace.getBlocksBoundingBox(), text, ground);
  } finally {
    workspace.dispose();
    place.remove();
  }
}

/** Draw a program of any size, and what the view of the blocks would leave out until it is in sight. */
function drawAll(workspace: Blockly.WorkspaceSvg, program: Workspace): void {
  const sync = new Sync(workspace, workspace.connectionChecker as Checker);
  sync.show(program);
  while (sync.isLoading) sync.addNext();
  const hidden = sync.hiddenBlocks().map(({ id }) => id);
  if (hidden.length) sync.draw(hidden, () => false);
}

function keepOnly(workspace: Blockly.WorkspaceSvg, id: string): void {
  const block = workspace.getBlockById(id);
  if (!block) return;
  block.unplug(true);
  for (const other of workspace.getTopBlocks(false)) if (other !== block) other.dispose(false);
}
