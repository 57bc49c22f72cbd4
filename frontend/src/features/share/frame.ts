/** Pictures of the world as it is drawn now. */

import type { WorldIsland } from "../../model/views";

/** Behind the world, which is transparent where nothing is. */
const SKY = "#dceaf8";
/** Where a higher picture is cut: buttons lie over its top, so its middle is lower. */
const LOW = 0.65;

/** `best` for a picture that is looked at longer than a moment; it takes longer, too. */
export type Quality = "best" | "usual";

/** Draw the world into a picture, which it fills; return whether there was a world to draw. */
export function drawWorld(world: WorldIsland, brush: CanvasRenderingContext2D, quality: Quality = "usual"): boolean {
  const source = world.dom.querySelector("canvas");
  if (!source?.width || !source.offsetParent) return false;
  // It draws the world now; a browser may forget what a canvas shows after that.
  if (quality === "best") world.drawBest();
  else world.resize();
  const { width, height } = brush.canvas;
  const scale = Math.max(width / source.width, height / source.height);
  const [across, down] = [source.width * scale, source.height * scale];
  brush.clearRect(0, 0, width, height);
  brush.drawImage(source, (width - across) / 2, (height - down) * LOW, across, down);
  return true;
}

/** Fill what is still transparent with the sky. */
export function fillSky(brush: CanvasRenderingContext2D): void {
  brush.globalCompositeOperation = "destination-over";
  brush.fillStyle = SKY;
  brush.fillRect(0, 0, brush.canvas.width, brush.canvas.height);
  brush.globalCompositeOperation = "source-over";
}

/** An empty picture of this size in pixels. */
export function newBrush(width: number, height: number): CanvasRenderingContext2D {
  const brush = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
  if (!brush) throw new Error("this browser cannot draw pictures");
  return brush;
}
