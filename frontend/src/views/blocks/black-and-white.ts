/** Pictures of blocks in black and white, to save ink; outlines and icons tell the blocks apart. */

/** Of the pictures on buttons, which do nothing on paper. */
const BUTTON = 'viewBox="0 0 16 16"';

/** Take the colours and the buttons out of a picture of blocks. */
export function inBlackAndWhite(svg: SVGElement): void {
  for (const shape of svg.querySelectorAll("path, rect, circle, polygon")) {
    if (shape.getAttribute("fill") !== "none") shape.setAttribute("fill", "#ffffff");
    shape.setAttribute("stroke", "#000000");
    shape.removeAttribute("fill-opacity");
  }
  for (const words of svg.querySelectorAll("text")) words.setAttribute("fill", "#000000");
  for (const icon of svg.querySelectorAll("image")) {
    if (decodeURIComponent(icon.getAttribute("href") ?? "").includes(BUTTON)) icon.remove();
    else icon.setAttribute("style", "filter: brightness(0)");
  }
}
