/** The face on a robot's screen: eyes and mouth for each emotion. */

import { type CanvasTexture, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import { createCanvas } from "./canvas";
import { letter } from "./lettering";

/** Fractions of the screen's height; positive is down. */
interface Expression {
  /** The opening of the eyes. */
  readonly eye: number;
  /** The drop of the brow's inner end. */
  readonly brow: number;
  /** The rise of the mouth's corners over its middle. */
  readonly smile: number;
  /** The opening of the mouth. */
  readonly open: number;
  readonly mouth: number;
}

const EXPRESSIONS: Readonly<Record<string, Expression>> = {
  neutral: { eye: 0.3, brow: 0, smile: 0, open: 0, mouth: 0.3 },
  joy: { eye: 0.3, brow: 0, smile: 0.17, open: 0.12, mouth: 0.46 },
  sadness: { eye: 0.24, brow: -0.1, smile: -0.13, open: 0, mouth: 0.34 },
  anger: { eye: 0.26, brow: 0.14, smile: -0.08, open: 0, mouth: 0.36 },
  surprise: { eye: 0.4, brow: -0.02, smile: 0, open: 0.22, mouth: 0.16 },
  fear: { eye: 0.38, brow: -0.12, smile: -0.05, open: 0.07, mouth: 0.34 },
  disgust: { eye: 0.14, brow: 0.06, smile: -0.1, open: 0.03, mouth: 0.36 },
};

/** What a robot shows without an emotion: two open eyes. */
const AWAKE: Expression = { eye: 0.44, brow: 0, smile: 0, open: 0, mouth: 0 };
/** The opening of closed eyes. */
const CLOSED = 0.07;
/** How far the light of the face shines, in pixels. */
const GLOW = 10;

/** A screen that shows a face; `none` shows open eyes only. */
export class Face {
  readonly mesh: Mesh;
  private readonly pen: CanvasRenderingContext2D;
  private readonly texture: CanvasTexture;
  private emotion = "";
  private text = "";
  private closed = false;

  /** @param width and height of the screen, mm; it faces ahead. */
  constructor(
    width: number,
    height: number,
    private readonly colour: string,
  ) {
    ({ pen: this.pen, texture: this.texture } = createCanvas(width, height));
    const screen = new PlaneGeometry(width, height).rotateX(Math.PI / 2).rotateZ(Math.PI / 2);
    this.mesh = new Mesh(screen, new MeshBasicMaterial({ map: this.texture, toneMapped: false }));
    this.show("none", "");
  }

  /** Show an emotion, or a text instead of it. */
  show(emotion: string, text: string): void {
    if (emotion === this.emotion && text === this.text) return;
    this.emotion = emotion;
    this.text = text;
    this.redraw();
  }

  /** Close or open the eyes; a text has none. */
  blink(closed: boolean): void {
    if (closed === this.closed) return;
    this.closed = closed;
    if (!this.text) this.redraw();
  }

  dispose(): void {
    this.texture.dispose();
  }

  private redraw(): void {
    const expression = EXPRESSIONS[this.emotion] ?? AWAKE;
    this.draw(this.closed ? { ...expression, eye: CLOSED } : expression);
    this.texture.needsUpdate = true;
  }

  private draw(expression: Expression): void {
    const { pen } = this;
    const { width, height } = pen.canvas;
    pen.resetTransform();
    pen.globalAlpha = 1;
    pen.shadowBlur = 0;
    pen.fillStyle = "#0b1020";
    pen.fillRect(0, 0, width, height);
    if (this.text) return letter(pen, this.text, this.colour, height / 2);
    // The face is drawn in fractions of the height, centred at (0, 0).
    pen.setTransform(height, 0, 0, height, width / 2, height / 2);
    pen.fillStyle = pen.strokeStyle = this.colour;
    pen.shadowColor = this.colour;
    pen.shadowBlur = GLOW;
    pen.lineCap = "round";
    this.features(expression);
  }

  private features(expression: Expression): void {
    for (const side of [-1, 1]) {
      this.eye(side, expression);
      if (expression.brow) this.brow(side, expression);
    }
    if (expression.mouth) this.mouth(expression);
  }

  /** A tall eye with a highlight; a smiling one is an arch. */
  private eye(side: number, { eye, smile, mouth }: Expression): void {
    const { pen } = this;
    const [x, y] = [side * 0.3, mouth ? -0.12 : 0];
    if (smile > 0.1) {
      pen.lineWidth = 0.1;
      return this.stroke([x - 0.14, y + 0.08], [x, y - 0.22], [x + 0.14, y + 0.08]);
    }
    pen.beginPath();
    pen.roundRect(x - 0.12, y - eye / 2, 0.24, eye, Math.min(0.12, eye / 2));
    pen.fill();
    pen.save();
    pen.shadowBlur = 0;
    pen.fillStyle = "rgba(255,255,255,.6)";
    pen.beginPath();
    pen.ellipse(x - 0.04, y - eye * 0.22, 0.04, eye * 0.14, 0, 0, 2 * Math.PI);
    pen.fill();
    pen.restore();
  }

  private brow(side: number, { brow, eye }: Expression): void {
    const y = -0.15 - eye / 2;
    this.pen.lineWidth = 0.05;
    this.stroke([side * 0.16, y + brow / 2], [side * 0.3, y], [side * 0.44, y - brow / 2]);
  }

  private mouth({ smile, open, mouth }: Expression): void {
    const [y, half] = [0.27, mouth / 2];
    this.pen.lineWidth = 0.055;
    if (!open) return this.stroke([-half, y - smile / 2], [0, y + smile], [half, y - smile / 2]);
    this.pen.beginPath();
    this.pen.moveTo(-half, y - smile / 2);
    this.pen.quadraticCurveTo(0, y - open * 0.6 + smile / 2, half, y - smile / 2);
    this.pen.quadraticCurveTo(0, y + open * 1.6 + smile, -half, y - smile / 2);
    this.pen.fill();
    this.pen.stroke();
  }

  private stroke(start: [number, number], middle: [number, number], end: [number, number]): void {
    this.pen.beginPath();
    this.pen.moveTo(...start);
    this.pen.quadraticCurveTo(...middle, ...end);
    this.pen.stroke();
  }
}
