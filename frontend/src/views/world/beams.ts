/** The beams of the robot's distance sensors. */

import { BufferGeometry, DoubleSide, DynamicDrawUsage, Float32BufferAttribute, Mesh, MeshBasicMaterial } from "three";
import type { Telemetry } from "../../protocol/messages";
import { MARKS } from "./scenery/colours";
import type { DistanceValues, RobotValues } from "./scenery/description";
import { from } from "./scenery/geometry";
import { distances } from "./scenery/readings";

const HEIGHT = 42;
/** Half of a beam's angle if the description gives none. */
const THINNEST = 0.9;

export class Beams {
  readonly object: Mesh;
  private readonly places: Float32BufferAttribute;

  constructor(private readonly robot: RobotValues) {
    this.places = new Float32BufferAttribute(new Float32Array(robot.distance.length * 9), 3);
    this.places.setUsage(DynamicDrawUsage);
    const material = new MeshBasicMaterial({
      color: MARKS.beam,
      transparent: true,
      opacity: 0.35,
      depthWrite: false,
      side: DoubleSide,
    });
    this.object = new Mesh(new BufferGeometry().setAttribute("position", this.places), material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 6;
  }

  /** Let each beam end at its reading, or at the end of its range. */
  show(telemetry: Telemetry): void {
    const readings = distances(this.robot, telemetry.sensors ?? []);
    this.robot.distance.forEach((sensor, i) => this.write(i, sensor, readings[i] ?? sensor.maximum));
    this.places.needsUpdate = true;
  }

  private write(i: number, { x, y, direction, beam }: DistanceValues, length: number): void {
    this.places.setXYZ(3 * i, x, y, HEIGHT);
    const half = Math.max(beam / 2, THINNEST);
    [direction - half, direction + half].forEach((heading, k) => {
      const [endX, endY] = from({ x, y, heading }, length);
      this.places.setXYZ(3 * i + 1 + k, endX, endY, HEIGHT);
    });
  }
}

/** Beams for a robot; null if it has no distance sensor. */
export function beams(robot: RobotValues): Beams | null {
  return robot.distance.length ? new Beams(robot) : null;
}
