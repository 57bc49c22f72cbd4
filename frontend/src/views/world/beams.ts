/** The beams of the robot's distance sensors, red where they meet something. */

import {
  BufferGeometry,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Float32BufferAttribute,
  Mesh,
  MeshBasicMaterial,
} from "three";
import type { Telemetry } from "../../protocol/messages";
import { MARKS } from "./scenery/colours";
import type { DistanceValues, RobotValues, XY } from "./scenery/description";
import { from } from "./scenery/geometry";
import { distances } from "./scenery/readings";

const HEIGHT = 42;
/** Half of a beam's angle if the description gives none. */
const THINNEST = 1.5;
/** Opacities at the sensor, at the end of the beam, and where it meets something. */
const NEAR = 0.7;
const FAR = 0.32;
const HIT = 0.95;
/** The thickness of the mark where a beam meets something, and its least width, mm. */
const MARK = 7;
const MARK_WIDTH = 26;
/** Of the beam, and of the mark at its end. */
const CORNERS = 3 + 6;

export class Beams {
  readonly object: Mesh<BufferGeometry, MeshBasicMaterial>;
  private side: string | null = null;
  private readonly places: Float32BufferAttribute;

  constructor(private readonly robot: RobotValues) {
    const geometry = new BufferGeometry();
    this.places = new Float32BufferAttribute(new Float32Array(robot.distance.length * CORNERS * 3), 3);
    this.places.setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", this.places);
    geometry.setAttribute("color", coloursFor(robot.distance.length));
    const material = new MeshBasicMaterial({
      vertexColors: true,
      toneMapped: false,
      fog: false,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 6;
  }

  /** Show only the beams of a side, also through the robot; null shows all. */
  single(side: string | null): void {
    this.side = side;
    this.object.material.depthTest = side === null;
  }

  /** Let each beam end at its reading, or at the end of its range. */
  show(telemetry: Telemetry): void {
    const readings = distances(this.robot, telemetry.sensors ?? []);
    this.robot.distance.forEach((sensor, i) => {
      if (this.shows(sensor)) this.write(i, sensor, readings[i] ?? null);
      else this.write(i, { ...sensor, maximum: 0 }, null);
    });
    this.places.needsUpdate = true;
  }

  private shows({ sides }: DistanceValues): boolean {
    return this.side === null || sides.some((side) => side === this.side);
  }

  private write(i: number, { x, y, direction, beam, maximum }: DistanceValues, reading: number | null): void {
    const length = reading ?? maximum;
    const half = Math.max(beam / 2, THINNEST);
    const [left, right] = [direction - half, direction + half].map((heading) => from({ x, y, heading }, length)) as [
      XY,
      XY,
    ];
    const first = i * CORNERS;
    this.put(first, [x, y]);
    this.put(first + 1, left);
    this.put(first + 2, right);
    // Without a reading, the mark has no size.
    const wide = reading === null ? 0 : Math.max(MARK_WIDTH, Math.hypot(left[0] - right[0], left[1] - right[1])) / 2;
    const middle = { x, y, heading: direction };
    const near = reading === null ? length : length - MARK;
    const corners = [from(middle, near, wide), from(middle, length, wide), from(middle, length, -wide)] as const;
    const last = from(middle, near, -wide);
    [corners[0], corners[1], corners[2], corners[0], corners[2], last].forEach((corner, k) =>
      this.put(first + 3 + k, corner),
    );
  }

  private put(i: number, [x, y]: XY): void {
    this.places.setXYZ(i, x, y, HEIGHT);
  }
}

/** Each beam fades towards its end; its mark does not. */
function coloursFor(count: number): Float32BufferAttribute {
  const [beam, hit] = [new Color(MARKS.beam), new Color(MARKS.hit)];
  const colours: number[] = [];
  for (let i = 0; i < count; i++) {
    for (const opacity of [NEAR, FAR, FAR]) colours.push(beam.r, beam.g, beam.b, opacity);
    for (let k = 3; k < CORNERS; k++) colours.push(hit.r, hit.g, hit.b, HIT);
  }
  return new Float32BufferAttribute(colours, 4);
}

/** Beams for a robot; null if it has no distance sensor. */
export function beams(robot: RobotValues): Beams | null {
  return robot.distance.length ? new Beams(robot) : null;
}
