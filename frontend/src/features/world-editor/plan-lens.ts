/** The world as a plan: the marks are in mm, y down as in SVG. */

import { groundOf } from "../../views/world/plan/ground";
import { shapesOf } from "../../views/world/plan/shapes";
import type { Ref } from "../../views/world/plan/sorts";
import { set, svg } from "../../views/world/plan/svg";
import type { WorldValues, XY } from "../../views/world/scenery/description";
import { between } from "../../views/world/scenery/geometry";
import type { Lens, Pointed } from "./lens";

/** The margin around the floor, as a fraction of its size. */
const MARGIN = 0.06;
const NEAREST = 100;
const FARTHEST = 40000;

export class PlanLens implements Lens {
  /** The marks are the picture. */
  readonly picture = null;
  private middle: XY = [0, 0];
  /** The size of the floor that is shown as a whole; null once the user has moved the view. */
  private whole: XY | null = null;
  /** mm per pixel. */
  scale = 4;

  constructor(
    private readonly plan: SVGSVGElement,
    private readonly changed: () => void,
  ) {}

  show(): void {}

  destroy(): void {}

  ground(world: WorldValues): SVGElement[] {
    return [...groundOf(world), svg("path", { d: "M0 -60 V60 M-60 0 H60", class: "axes" })];
  }

  shapes(world: WorldValues, ref: Ref): SVGElement[] {
    return shapesOf(world, ref);
  }

  point([x, y]: XY): XY {
    return [x, -y];
  }

  /** Show a whole floor. */
  fit([east, north]: XY): void {
    const { clientWidth, clientHeight } = this.plan;
    const room = 1 + 2 * MARGIN;
    this.whole = [east, north];
    this.middle = [0, 0];
    this.scale = Math.max((east * room) / Math.max(1, clientWidth), (north * room) / Math.max(1, clientHeight));
    this.apply();
  }

  /** Zoom in with a factor below 1, keeping a point of the world at its position on the screen. */
  zoom(factor: number, [x, y]: XY = this.middle): void {
    this.whole = null;
    const width = this.plan.clientWidth;
    const scale = between(this.scale * factor, NEAREST / width, FARTHEST / width);
    const part = scale / this.scale;
    this.middle = [x + (this.middle[0] - x) * part, y + (this.middle[1] - y) * part];
    this.scale = scale;
    this.apply();
  }

  /** Shift by pixels. */
  pan(right: number, down: number): void {
    this.whole = null;
    this.middle = [this.middle[0] - right * this.scale, this.middle[1] + down * this.scale];
    this.apply();
  }

  /** The middle of the visible part, in the world. */
  get centre(): XY {
    return this.middle;
  }

  /** The position in the world at a position on the page. */
  at({ clientX, clientY }: Pointed): XY {
    const box = this.plan.getBoundingClientRect();
    const right = (clientX - box.left - box.width / 2) * this.scale;
    const down = (clientY - box.top - box.height / 2) * this.scale;
    return [this.middle[0] + right, this.middle[1] - down];
  }

  /** The plan has another size now: a whole floor stays whole. */
  resized(): void {
    if (this.whole) this.fit(this.whole);
    else this.apply();
  }

  apply(): void {
    const [width, height] = [this.plan.clientWidth * this.scale, this.plan.clientHeight * this.scale];
    const [x, y] = this.middle;
    set(this.plan, { viewBox: `${x - width / 2} ${-y - height / 2} ${width} ${height}` });
    this.changed();
  }
}
