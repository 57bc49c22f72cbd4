/** A camera's picture with marks on what was recognised. */

import type { CameraFrame, Seen } from "../../protocol/messages";

const COLOURS: Record<Seen["sort"], string> = { tag: "#ffe900", face: "#5dff93", line: "#5ad1ff" };

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

function label(pen: CanvasRenderingContext2D, { corners, sort }: Seen, text: string): void {
  const x = Math.max(2, Math.min(...corners.map((corner) => corner[0])));
  const y = Math.max(16, Math.min(...corners.map((corner) => corner[1])) - 5);
  pen.font = "bold 14px system-ui, sans-serif";
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
