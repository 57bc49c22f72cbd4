/** Pictures as files: SVG for paper and documents, PNG for everything else. */

/** Pixels of a PNG for each of the page, so that it is sharp on paper. */
const SHARPNESS = 2;
/** The longest side that every browser can draw, in pixels. */
const LONGEST = 8192;

/** The text of an SVG's file. */
export function svgText(svg: SVGElement): string {
  return new XMLSerializer().serializeToString(svg);
}

/** An SVG as the address of an image. */
export function svgAddress(svg: SVGElement): string {
  return `data:image/svg+xml,${encodeURIComponent(svgText(svg))}`;
}

/** An SVG of that size as pixels. */
export async function svgCanvas(svg: SVGElement, width: number, height: number): Promise<HTMLCanvasElement> {
  const scale = Math.min(SHARPNESS, LONGEST / Math.max(width, height));
  const size = { width: Math.round(width * scale), height: Math.round(height * scale) };
  const image = new Image(size.width, size.height);
  await new Promise((resolve, reject) =>
    Object.assign(image, { onload: resolve, onerror: reject, src: svgAddress(svg) }),
  );
  const canvas = Object.assign(document.createElement("canvas"), size);
  canvas.getContext("2d")!.drawImage(image, 0, 0, size.width, size.height);
  return canvas;
}

/** The pixels of an SVG of that size, as a PNG. */
export async function svgPixels(svg: SVGElement, width: number, height: number): Promise<Blob> {
  const canvas = await svgCanvas(svg, width, height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((png) => (png ? resolve(png) : reject(new Error("the browser made no PNG"))), "image/png");
  });
}
