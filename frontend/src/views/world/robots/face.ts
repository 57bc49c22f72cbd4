/** The face on a robot's screen: eyes and mouth for each emotion. */

import { CanvasTexture, Mesh, MeshBasicMaterial, PlaneGeometry, SRGBColorSpace } from "three";

const HEIGHT = 128;

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

/** A screen that shows a face; `none` shows closed eyes, dimly. */
export class Face {
  readonly mesh: Mesh;
  private readonly pen: CanvasRenderingContext2D;
  private readonly texture: CanvasTexture;
  private emotion = "";

  /** @param width and height of the screen, mm; it faces ahead. */
  constructor(
    width: number,
    height: number,
    private readonly colour: string,
  ) {
    const canvas = document.createElement("canvas");
    canvas.height = HEIGHT;
    canvas.width = Math.round((HEIGHT * width) / height);
    this.pen = canvas.getContext("2d") as CanvasRenderingContext2D;
    this.texture = new CanvasTexture(canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.anisotropy = 4;
    const screen = new PlaneGeometry(width, height).rotateX(Math.PI / 2).rotateZ(Math.PI / 2);
    this.mesh = new Mesh(screen, new MeshBasicMaterial({ map: this.texture }));
    this.show("none");
  }

  show(emotion: string): void {
    if (emotion === this.emotion) return;
    this.emotion = emotion;
    this.draw(EXPRESSIONS[emotion]);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }

  private draw(expression: Expression | undefined): void {
    const { pen } = this;
    const { width, height } = pen.canvas;
    pen.resetTransform();
    pen.globalAlpha = 1;
    pen.fillStyle = "#10151d";
    pen.fillRect(0, 0, width, height);
    // The face is drawn in fractions of the height, centred at (0, 0).
    pen.setTransform(height, 0, 0, height, width / 2, height / 2);
    pen.fillStyle = pen.strokeStyle = this.colour;
    pen.lineCap = "round";
    if (expression) this.awake(expression);
    else this.asleep();
  }

  private asleep(): void {
    this.pen.globalAlpha = 0.4;
    this.pen.lineWidth = 0.05;
    for (const side of [-1, 1]) this.stroke([side * 0.28 - 0.1, 0], [side * 0.28, 0.05], [side * 0.28 + 0.1, 0]);
  }

  private awake(expression: Expression): void {
    for (const side of [-1, 1]) {
      this.eye(side, expression);
      if (expression.brow) this.brow(side, expression);
    }
    this.mouth(expression);
  }

  private eye(side: number, { eye }: Expression): void {
    this.pen.beginPath();
    this.pen.ellipse(side * 0.3, -0.12, 0.105, eye / 2, 0, 0, 2 * Math.PI);
    this.pen.fill();
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
