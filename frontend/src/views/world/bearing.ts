/** The heading of a robot on the floor: an arrow, and the angle to it from east, where headings begin. */

import { CircleGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Shape, ShapeGeometry } from "three";

import { MARKS } from "./scenery/colours";
import { type Pose, radians } from "./scenery/geometry";

/** mm over the floor, beyond the robot, and of the arrow. */
const HEIGHT = 3;
const BEYOND = 130;
const [SHAFT, HEAD] = [7, 24] as const;
const FILLED = 0.35;
/** Over the trail and things. */
const ORDER = 7;

export class Bearing {
  readonly object = new Group();
  private readonly angle = new Mesh(new CircleGeometry(), flat(FILLED));
  private readonly needle = new Mesh(new ShapeGeometry(), flat(1));
  private readonly east = new Mesh(new ShapeGeometry(), flat(FILLED));
  private reach = 0;
  private heading = Number.NaN;

  constructor() {
    this.object.add(this.needle, this.east, this.angle);
    for (const mesh of [this.needle, this.east, this.angle]) mesh.renderOrder = ORDER;
    this.object.visible = false;
  }

  /** Lay it around a robot. */
  show({ x, y, heading }: Pose, reach: number): void {
    this.object.position.set(x, y, HEIGHT);
    this.needle.rotation.z = -radians(heading);
    if (reach !== this.reach) this.resize(reach);
    if (heading !== this.heading) this.open(heading);
  }

  dispose(): void {
    for (const mesh of [this.needle, this.east, this.angle]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }

  private resize(reach: number): void {
    this.reach = reach;
    this.heading = Number.NaN;
    for (const mesh of [this.needle, this.east]) {
      mesh.geometry.dispose();
      mesh.geometry = new ShapeGeometry(arrow(reach + BEYOND));
    }
  }

  private open(heading: number): void {
    this.heading = heading;
    this.angle.geometry.dispose();
    this.angle.geometry = new CircleGeometry(this.reach + BEYOND / 2, 40, 0, -radians(heading));
  }
}

function flat(opacity: number): MeshBasicMaterial {
  return new MeshBasicMaterial({
    color: MARKS.beam,
    transparent: true,
    opacity,
    side: DoubleSide,
    depthWrite: false,
    // Seen also behind the robot.
    depthTest: false,
    toneMapped: false,
  });
}

/** An arrow to the east. */
function arrow(length: number): Shape {
  const neck = length - 2 * HEAD;
  return new Shape()
    .moveTo(0, -SHAFT)
    .lineTo(neck, -SHAFT)
    .lineTo(neck, -HEAD)
    .lineTo(length, 0)
    .lineTo(neck, HEAD)
    .lineTo(neck, SHAFT)
    .lineTo(0, SHAFT);
}
