/** A speech bubble above a robot with the text that it shows, legible from every side. */

import { CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace } from "three";
import { wrap } from "./lettering";

const FONT = 30;
const LINE = 38;
const PADDING = 18;
const TAIL = 18;
/** Pixels of the longest line. */
const WIDEST = 380;
/** The height of a line on the page, as a part of the distance. */
const SCALE = 0.034;
const GAP = 25;

export class Bubble {
  readonly sprite = new Sprite(new SpriteMaterial({ depthTest: false, sizeAttenuation: false }));
  private text = "";

  /** @param height of the robot, mm. */
  constructor(height: number) {
    this.lift(height);
    this.sprite.center.set(0.5, 0);
    this.sprite.renderOrder = 10;
    this.sprite.visible = false;
  }

  /** Put it above what is as high as this, mm. */
  lift(height: number): void {
    this.sprite.position.z = height + GAP;
  }

  show(text: string): void {
    if (text === this.text) return;
    this.text = text;
    this.sprite.visible = text !== "";
    if (text) this.draw(text);
  }

  dispose(): void {
    this.sprite.material.map?.dispose();
    this.sprite.material.dispose();
  }

  private draw(text: string): void {
    const canvas = document.createElement("canvas");
    const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
    const font = `600 ${FONT}px sans-serif`;
    pen.font = font;
    const lines = wrap(text, WIDEST, (line) => pen.measureText(line).width);
    const width = Math.max(...lines.map((line) => pen.measureText(line).width), LINE);
    canvas.width = Math.ceil(width) + 2 * PADDING;
    canvas.height = lines.length * LINE + 2 * PADDING + TAIL;
    // A canvas of another size forgets its font.
    pen.font = font;
    balloon(pen);
    pen.fillStyle = "#1c2430";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    lines.forEach((line, i) => pen.fillText(line, canvas.width / 2, PADDING + (i + 0.5) * LINE));
    const { material } = this.sprite;
    material.map?.dispose();
    material.map = new CanvasTexture(canvas);
    material.map.colorSpace = SRGBColorSpace;
    material.needsUpdate = true;
    const scale = SCALE / LINE;
    this.sprite.scale.set(canvas.width * scale, canvas.height * scale, 1);
  }
}

function balloon(pen: CanvasRenderingContext2D): void {
  const { width, height } = pen.canvas;
  pen.fillStyle = "#ffffff";
  pen.strokeStyle = "#8792a5";
  pen.lineWidth = 3;
  const [middle, bottom] = [width / 2, height - TAIL];
  for (const outline of ["stroke", "fill"] as const) {
    pen.beginPath();
    pen.roundRect(2, 2, width - 4, bottom - 4, 16);
    pen[outline]();
    pen.beginPath();
    pen.moveTo(middle - TAIL * 0.7, bottom - 4);
    pen.lineTo(middle, height - 3);
    pen.lineTo(middle + TAIL * 0.7, bottom - 4);
    pen[outline]();
  }
}
