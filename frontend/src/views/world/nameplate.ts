/** The name of a robot, above it. */

import { CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace } from "three";

/** The height of a name and its distance from the floor, mm. */
const SIZE = 64;
const ABOVE = 200;
/** The size of the drawing in pixels: of the letters, and of the space beside them. */
const LETTERS = 44;
const MARGIN = 18;
const FONT = `600 ${LETTERS}px system-ui, sans-serif`;

/** A name that always faces the camera, white on a colour. */
export function nameplate(name: string, color: string): Sprite {
  const canvas = draw(name, color);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false }));
  sprite.scale.set((SIZE * canvas.width) / canvas.height, SIZE, 1);
  sprite.position.set(0, 0, ABOVE);
  return sprite;
}

function draw(name: string, color: string): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  const measured = canvas.getContext("2d");
  if (measured) measured.font = FONT;
  canvas.width = Math.ceil(measured?.measureText(name).width ?? 0) + 2 * MARGIN;
  canvas.height = LETTERS + MARGIN;
  const pen = canvas.getContext("2d");
  if (pen) write(pen, name, color);
  return canvas;
}

function write(pen: CanvasRenderingContext2D, name: string, color: string): void {
  const { width, height } = pen.canvas;
  pen.fillStyle = color;
  pen.beginPath();
  pen.roundRect(0, 0, width, height, MARGIN);
  pen.fill();
  pen.font = FONT;
  pen.fillStyle = "white";
  pen.textBaseline = "middle";
  pen.fillText(name, MARGIN, height / 2);
}
