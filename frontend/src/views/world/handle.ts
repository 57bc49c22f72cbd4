/** The ring around a robot that is being placed: its knob turns the robot. */

import { CircleGeometry, Group, Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from "three";

import { MARKS } from "./scenery/colours";
import { from, type Pose } from "./scenery/geometry";
import { place } from "./scenery/things";

const GAP = 26;
const KNOB = 20;
const HEIGHT = 3;

export class Handle {
  readonly object = new Group();
  private readonly knob: Mesh;
  private radius = 0;

  constructor() {
    const material = new MeshBasicMaterial({
      color: MARKS.handle,
      toneMapped: false,
      transparent: true,
      opacity: 0.85,
      depthTest: false,
    });
    this.knob = new Mesh(new CircleGeometry(KNOB, 28), material);
    this.object.add(new Mesh(new RingGeometry(0.94, 1, 56), material), this.knob);
    this.object.renderOrder = 8;
    this.object.visible = false;
  }

  /** Fit it around a robot with this radius, mm. */
  show(pose: Pose, reach: number): void {
    this.radius = reach + GAP;
    this.object.visible = true;
    this.object.children[0]?.scale.setScalar(this.radius);
    this.knob.position.x = this.radius;
    place(this.object, pose);
    this.object.position.z = HEIGHT;
  }

  hide(): void {
    this.object.visible = false;
  }

  /** The knob's position in the world. */
  at(pose: Pose): Vector3 {
    return new Vector3(...from(pose, this.radius), HEIGHT);
  }
}
