/** The canvas of a robot's screen. */

import { CanvasTexture, SRGBColorSpace } from "three";

/** Pixels from the upper to the lower edge. */
const HEIGHT = 128;

export interface ScreenCanvas {
  readonly pen: CanvasRenderingContext2D;
  readonly texture: CanvasTexture;
}

/** Create the canvas of a screen with these proportions, and the texture that shows it. */
export function createCanvas(width: number, height: number): ScreenCanvas {
  const canvas = document.createElement("canvas");
  canvas.height = HEIGHT;
  canvas.width = Math.round((HEIGHT * width) / height);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  return { pen: canvas.getContext("2d") as CanvasRenderingContext2D, texture };
}
