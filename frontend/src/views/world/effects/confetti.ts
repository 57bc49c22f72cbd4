/** Confetti that bursts up from a place and falls. */

import { Color, DoubleSide, InstancedMesh, MeshBasicMaterial, Object3D, PlaneGeometry } from "three";

import type { XY } from "../scenery/description";
import type { Effect } from "./effects";

const PIECES = 90;
const SIZE = 15;
const COLOURS = ["#ef4444", "#ffc933", "#2fae5b", "#38a3ff", "#8257e6", "#f0529c"] as const;
/** mm above the floor. */
const HEIGHT = 60;
/** mm/s, and mm/s². */
const UP = 900;
const OUT = 330;
const GRAVITY = 900;
/** Turns per second. */
const SPIN = 1.6;
/** The share of its time after which it shrinks. */
const FADES = 0.75;
const GOLDEN = 2.399963;

export class Confetti implements Effect {
  readonly object: InstancedMesh;
  readonly lasts = 2000;
  private readonly piece = new Object3D();

  constructor(private readonly place: XY) {
    const material = new MeshBasicMaterial({ side: DoubleSide, toneMapped: false, fog: false });
    this.object = new InstancedMesh(new PlaneGeometry(SIZE, SIZE * 0.6), material, PIECES);
    this.object.frustumCulled = false;
    COLOURS.forEach((_, i) => {
      const color = new Color(COLOURS[i]);
      for (let k = i; k < PIECES; k += COLOURS.length) this.object.setColorAt(k, color);
    });
  }

  show(age: number): void {
    const seconds = age / 1000;
    const left = 1 - age / this.lasts;
    const size = Math.min(1, left / (1 - FADES));
    for (let i = 0; i < PIECES; i++) this.put(i, seconds, size);
    this.object.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.object.geometry.dispose();
    (this.object.material as MeshBasicMaterial).dispose();
    this.object.dispose();
  }

  private put(i: number, seconds: number, size: number): void {
    const share = (i + 0.5) / PIECES;
    const angle = i * GOLDEN;
    const out = OUT * Math.sqrt(share) * seconds;
    const up = UP * (1 - 0.55 * share) * seconds - (GRAVITY / 2) * seconds * seconds;
    const turn = 2 * Math.PI * SPIN * seconds + angle;
    this.piece.position.set(
      this.place[0] + out * Math.cos(angle),
      this.place[1] + out * Math.sin(angle),
      Math.max(2, HEIGHT + up),
    );
    this.piece.rotation.set(turn, turn * 0.7, angle);
    this.piece.scale.setScalar(size);
    this.piece.updateMatrix();
    this.object.setMatrixAt(i, this.piece.matrix);
  }
}
