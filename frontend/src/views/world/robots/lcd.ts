/** The screen on top of a brick, which shows text. */

import { type CanvasTexture, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import { createCanvas } from "./canvas";
import { letter } from "./lettering";

/** Of EV3's screen. */
const GREY = { paper: "#b9cdb4", ink: "#1d2a1f" } as const;

export class Lcd {
  readonly mesh: Mesh;
  private readonly pen: CanvasRenderingContext2D;
  private readonly texture: CanvasTexture;
  private text: string | null = null;

  /** @param width and height of the screen, mm; its upper edge is ahead. */
  constructor(
    width: number,
    height: number,
    private readonly colours: { readonly paper: string; readonly ink: string } = GREY,
  ) {
    ({ pen: this.pen, texture: this.texture } = createCanvas(width, height));
    const screen = new PlaneGeometry(width, height).rotateZ(-Math.PI / 2);
    this.mesh = new Mesh(screen, new MeshBasicMaterial({ map: this.texture, toneMapped: false }));
    this.show("none", "");
  }

  show(_emotion: string, text: string): void {
    if (text === this.text) return;
    this.text = text;
    const { width, height } = this.pen.canvas;
    this.pen.fillStyle = this.colours.paper;
    this.pen.fillRect(0, 0, width, height);
    letter(this.pen, text, this.colours.ink, 44);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}
