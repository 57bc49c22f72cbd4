/** The program on paper: the blocks of each stack beside the numbered lines of its Block-Text. */

import { language, t } from "../../i18n";
import type { Page } from "../../model/page";
import type { Workspace } from "../../protocol/messages";
import { svgAddress } from "../../ui/picture-file";
import type { PortablePicture } from "../../views/blocks/portable-svg";
import { loadDrawing } from "./draw-program";
import { bands, type Lines, linesOfStacks } from "./print-layout";
import "./print.css";

/** CSS pixels: the most of A4's width that blocks take, and the height of a piece that stays on one page. */
const COLUMN = 400;
const PIECE = 240;
/** The largest size of blocks, as a share of that on the page. */
const LARGEST = 0.7;

/** A program to print. */
export interface PrintedProgram {
  /** Without stacks, the lines are printed alone. */
  readonly workspace: Workspace;
  readonly blocktext: string;
  /** Where its blocks are in the text. */
  readonly places: readonly Lines[];
  readonly title: string;
  /** Below the title. */
  readonly about: string;
  /** Whose it is. */
  readonly name: string;
}

/** Print the program of the page. */
export async function printProgram({ context, project }: Page): Promise<void> {
  const robot = project.robotTitle(context.running.robot.peek());
  const world = project.worldTitle(context.running.world.peek());
  await printPrograms([
    {
      ...context.program.state.peek(),
      title: project.name.peek(),
      about: t("page-project-on-in", { robot, world }),
      name: t("page-share-print-name"),
    },
  ]);
}

/** Lay programs out for paper, each on a page of its own, and let the browser print them. */
export async function printPrograms(programs: readonly PrintedProgram[]): Promise<void> {
  const sheet = element("section", "print-sheet");
  for (const program of programs) {
    const part = element("article");
    part.append(head(program), ...(await rows(program)));
    sheet.append(part);
  }
  const images = [...sheet.querySelectorAll("img")];
  sheet.style.setProperty("--print-blocks", `${Math.max(0, ...images.map(({ width }) => width))}px`);
  await Promise.all(images.map((image) => image.decode()));
  document.body.append(sheet);
  addEventListener("afterprint", () => sheet.remove(), { once: true });
  window.print();
}

function head({ title, about, name }: PrintedProgram): HTMLElement {
  const part = element("header");
  part.append(element("h1", "", title), element("p", "", about), element("p", "print-name", name));
  return part;
}

async function rows({ workspace, blocktext, places }: PrintedProgram): Promise<HTMLElement[]> {
  const [drawProgram, { slice }] = await Promise.all([loadDrawing(), import("../../views/blocks/portable-svg")]);
  const choices = { language: language.peek(), theme: "light", text: "", only: null } as const;
  const drawn: HTMLElement[] = [];
  for (const { stack, first, lines } of linesOfStacks(workspace, blocktext, places)) {
    const picture = stack && (await drawProgram({ ...workspace, stacks: [stack] }, choices));
    drawn.push(row(picture ? pieces(picture, slice) : [], lines, first));
  }
  return drawn;
}

/** A picture in pieces, between which a page may end. */
function pieces(picture: PortablePicture, slice: typeof import("../../views/blocks/portable-svg").slice) {
  const scale = Math.min(LARGEST, COLUMN / picture.width);
  return bands(picture.height, picture.words, PIECE / scale).map(({ top, bottom }) => {
    // They overlap, so that no line is between them.
    const piece = slice(picture, { top, bottom: bottom + 1 });
    return Object.assign(new Image(picture.width * scale), { alt: "", src: svgAddress(piece) });
  });
}

function row(images: readonly HTMLImageElement[], lines: readonly string[], first: number): HTMLElement {
  const blocks = element("div");
  blocks.append(...images);
  const list = element("ol");
  list.setAttribute("start", String(first));
  list.append(...lines.map(numbered));
  const part = element("div", "print-row");
  part.append(blocks, list);
  return part;
}

/** A line of a list; what does not fit is below it, farther in. */
function numbered(line: string): HTMLElement {
  const item = element("li", "", line || " ");
  const indent = line.search(/\S|$/) + 2;
  Object.assign(item.style, { paddingInlineStart: `${indent}ch`, textIndent: `-${indent}ch` });
  return item;
}

function element(tag: string, name = "", text = ""): HTMLElement {
  return Object.assign(document.createElement(tag), { className: name, textContent: text });
}
