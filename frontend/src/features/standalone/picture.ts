/** Draws a picture for the command line, which reads it from the document. */

import { inBase64 } from "../../ui/files";
import { svgCanvas, svgText } from "../../ui/picture-file";
import { givePalette, prepareBlockly } from "../../views/blocks/palette";
import type { PortablePicture } from "../../views/blocks/portable-svg";
import { drawProgram } from "../../views/blocks/program-picture";
import type { PictureContent } from "./content";

/** Draw the picture; the document then consists of its file in base64. */
export async function writePicture(content: PictureContent): Promise<void> {
  givePalette(content.palette);
  prepareBlockly();
  const choices = { language: content.language, theme: content.theme, text: content.text, only: null };
  const picture = await drawProgram(content.workspace, choices);
  document.body.replaceChildren(await (content.type === "svg" ? svgFile(picture) : pngFile(picture)));
  document.body.dataset.done = "";
}

function svgFile({ svg }: PortablePicture): Promise<string> {
  return inBase64(new File([svgText(svg)], "picture"));
}

/** Without `toBlob`, for which the virtual time of a browser without a window does not wait. */
async function pngFile({ svg, width, height }: PortablePicture): Promise<string> {
  const canvas = await svgCanvas(svg, width, height);
  return canvas.toDataURL("image/png").split(",")[1]!;
}
