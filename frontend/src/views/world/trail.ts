/** The robot's trail: a ribbon on the floor. */

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, MeshBasicMaterial } from "three";

import { MARKS } from "./scenery/colours";
import type { XY } from "./scenery/description";

/** mm between two points. */
const STEP = 8;
const HALF_WIDTH = 5;
const HEIGHT = 1.6;
/** At this many points every second one is dropped, so a long run keeps its whole trail. */
const MOST_POINTS = 4000;
const CORNERS = 6;

interface Look {
  readonly colour: string;
  readonly halfWidth: number;
  /** Over the floor, mm. */
  readonly height: number;
}

const OWN: Look = { colour: MARKS.trail, halfWidth: HALF_WIDTH, height: HEIGHT };

export class Trail {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  private points: XY[] = [];
  private readonly places = new BufferAttribute(new Float32Array(MOST_POINTS * CORNERS * 3), 3);

  constructor(private readonly look: Look = OWN) {
    this.places.setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry().setAttribute("position", this.places);
    const material = new MeshBasicMaterial({
      color: look.colour,
      toneMapped: false,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -4,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 4;
    this.clear();
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  clear(): void {
    this.points = [];
    this.mesh.geometry.setDrawRange(0, 0);
  }

  /** Highlight it, or draw it in its own colour again. */
  highlight(on: boolean): void {
    this.mesh.material.color.set(on ? MARKS.beam : this.look.colour);
  }

  /** Extend the trail to the robot. */
  extend(x: number, y: number): void {
    const last = this.points.at(-1);
    if (last && Math.hypot(x - last[0], y - last[1]) < STEP) return;
    this.points.push([x, y]);
    if (this.points.length > MOST_POINTS) this.thin();
    else this.write(this.points.length - 1);
  }

  private thin(): void {
    this.points = this.points.filter((_, i) => i % 2 === 0);
    this.points.forEach((_, i) => this.write(i));
  }

  /** Write the piece that ends at a point. */
  private write(i: number): void {
    const [start, end] = [this.points[i - 1], this.points[i]];
    if (!start || !end) return;
    for (const [k, [x, y]] of piece(start, end, this.look.halfWidth).entries())
      this.places.setXYZ((i - 1) * CORNERS + k, x, y, this.look.height);
    this.places.addUpdateRange((i - 1) * CORNERS * 3, CORNERS * 3);
    this.places.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, i * CORNERS);
  }
}

/** The corners of the two triangles of a piece. It begins a little earlier, so that bends have no gap outside. */
function piece([x, y]: XY, [endX, endY]: XY, halfWidth: number): XY[] {
  const length = Math.hypot(endX - x, endY - y);
  const [alongX, alongY] = [((endX - x) / length) * halfWidth, ((endY - y) / length) * halfWidth];
  const right: XY = [x - alongX + alongY, y - alongY - alongX];
  const left: XY = [x - alongX - alongY, y - alongY + alongX];
  const endRight: XY = [endX + alongY, endY - alongX];
  const endLeft: XY = [endX - alongY, endY + alongX];
  return [right, endRight, endLeft, right, endLeft, left];
}
