/** A camera's picture with marks on what was recognised. */

import type { CameraFrame, Seen } from "../../protocol/messages";

const COLOURS: Record<Seen["sort"], string> = {
  tag: "#ffe900",
  face: "#5dff93",
  line: "#5ad1ff",
  object: "#ff9ecb",
};

/** Pixels: the size of letters, the height of a line of them, and the least distance to the picture's edge. */
const LETTERS = 14;
const LINE = 16;
const EDGE = 3;

function trace(pen: CanvasRenderingContext2D, { corners }: Seen): void {
  pen.beginPath();
  for (const [x, y] of corners) pen.lineTo(x, y);
  pen.closePath();
}

/** Bright on dark, so that it is visible on any background. */
function outline(pen: CanvasRenderingContext2D, seen: Seen): void {
  trace(pen, seen);
  for (const [width, colour] of [
    [5, "#000"],
    [2.5, COLOURS[seen.sort]],
  ] as const) {
    pen.lineWidth = width;
    pen.strokeStyle = colour;
    pen.stroke();
  }
}

/** Where a label begins: above what it names, and as a whole inside of the picture. */
export function labelPlace(
  corners: Seen["corners"],
  label: number,
  { width, height }: { readonly width: number; readonly height: number },
): readonly [x: number, y: number] {
  const left = Math.min(...corners.map(([x]) => x));
  const top = Math.min(...corners.map(([, y]) => y));
  const inside = Math.min(left, width - label - EDGE);
  return [Math.max(EDGE, inside), Math.min(Math.max(LINE, top - 5), height - EDGE)];
}

function label(pen: CanvasRenderingContext2D, { corners, sort }: Seen, text: string): void {
  pen.font = `bold ${LETTERS}px system-ui, sans-serif`;
  const [x, y] = labelPlace(corners, pen.measureText(text).width, pen.canvas);
  pen.lineWidth = 4;
  pen.strokeStyle = "#000";
  pen.fillStyle = COLOURS[sort];
  pen.strokeText(text, x, y);
  pen.fillText(text, x, y);
}

/** Draw a frame and mark what was recognised; `name` gives each label. */
export function drawFrame(
  canvas: HTMLCanvasElement,
  image: ImageBitmap,
  frame: CameraFrame,
  name: (seen: Seen) => string,
): void {
  if (canvas.width !== frame.width) canvas.width = frame.width;
  if (canvas.height !== frame.height) canvas.height = frame.height;
  const pen = canvas.getContext("2d");
  if (!pen) return;
  pen.drawImage(image, 0, 0, frame.width, frame.height);
  for (const seen of (frame.seen ?? []).filter(({ corners }) => corners.length > 0)) {
    outline(pen, seen);
    label(pen, seen, name(seen));
  }
}
