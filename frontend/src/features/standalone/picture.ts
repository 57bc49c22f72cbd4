/** Draws a picture for the command line, which reads it from the document. */

import { inBase64 } from "../../ui/files";
import { svgPixels, svgText } from "../../ui/picture-file";
import { givePalette, prepareBlockly } from "../../views/blocks/palette";
import { drawProgram } from "../../views/blocks/program-picture";
import type { PictureContent } from "./content";

/** Draw the picture; the document then consists of its file in base64. */
export async function writePicture(content: PictureContent): Promise<void> {
  givePalette(content.palette);
  prepareBlockly();
  const choices = { language: content.language, theme: content.theme, text: content.text, only: null };
  const { svg, width, height } = await drawProgram(content.workspace, choices);
  const isSvg = content.type === "svg";
  const file = isSvg ? new Blob([svgText(svg)]) : await svgPixels(svg, width, height);
  document.body.replaceChildren(await inBase64(new File([file], "picture")));
  document.body.dataset.done = "";
}
