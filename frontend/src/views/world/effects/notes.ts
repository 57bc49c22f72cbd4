/** What a robot sounds like: notes that rise from it, or waves when it speaks. */

import { CanvasTexture, Group, Sprite, SpriteMaterial, SRGBColorSpace } from "three";

import type { Effect } from "./effects";

const PIXELS = 64;
const SIZE = 46;
/** mm that a note rises, and how far it swings. */
const RISE = 150;
const SWING = 26;
/** ms between two notes, and how many there are. */
const GAP = 180;
const COUNT = 3;
const ONE = 1000;
const SIGNS = { notes: ["♪", "♫", "♩"], speech: ["(", "((", "((("] } as const;
const COLOURS = ["#7c3aed", "#c4267f", "#2563eb"] as const;

export class Notes implements Effect {
  readonly object = new Group();
  readonly lasts = ONE + GAP * (COUNT - 1);

  /** @param height of the robot whose group this joins, mm. */
  constructor(
    kind: keyof typeof SIGNS,
    private readonly place: { readonly x: number; readonly y: number; readonly height: number },
  ) {
    SIGNS[kind].forEach((sign, i) => {
      const sprite = new Sprite(new SpriteMaterial({ map: drawn(sign, i), depthTest: false, toneMapped: false }));
      sprite.scale.setScalar(SIZE);
      sprite.renderOrder = 9;
      this.object.add(sprite);
    });
  }

  show(age: number): void {
    this.object.children.forEach((sprite, i) => {
      const part = (age - i * GAP) / ONE;
      sprite.visible = part >= 0 && part < 1;
      const swing = SWING * Math.sin(part * 7 + i * 2);
      sprite.position.set(this.place.x + swing, this.place.y, this.place.height + 30 + RISE * part);
      (sprite as Sprite).material.opacity = Math.min(1, 3 * (1 - part));
    });
  }

  dispose(): void {
    for (const sprite of this.object.children as Sprite[]) {
      sprite.material.map?.dispose();
      sprite.material.dispose();
    }
  }
}

function drawn(sign: string, index: number): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = PIXELS;
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  pen.fillStyle = pen.strokeStyle = COLOURS[index % COLOURS.length] as string;
  if (sign.startsWith("(")) waves(pen, sign.length);
  else {
    pen.font = `bold ${PIXELS * 0.9}px sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.strokeStyle = "#ffffff";
    pen.lineWidth = 6;
    pen.strokeText(sign, PIXELS / 2, PIXELS / 2 + 4);
    pen.fillText(sign, PIXELS / 2, PIXELS / 2 + 4);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** Arcs that open upwards. */
function waves(pen: CanvasRenderingContext2D, count: number): void {
  pen.lineWidth = 6;
  pen.lineCap = "round";
  for (let i = 1; i <= count; i++) {
    pen.beginPath();
    pen.arc(PIXELS / 2, PIXELS - 10, 14 * i, -0.75 * Math.PI, -0.25 * Math.PI);
    pen.stroke();
  }
}
