/** A robot as it is drawn: what every kind has in common. */

import { Group, type Mesh, MeshBasicMaterial, Object3D } from "three";

import type { RobotValues, XY } from "../description";
import { radians, wrapped } from "../geometry";
import { shadows } from "../shadows";
import { place } from "../things";
import { Face } from "./face";
import { Wheel } from "./wheel";
import type { Robot } from "../../messages";

const LED_OFF = "#59606b";

/** How a kind of robot looks. Places are mm ahead, to the left and up. */
export interface Look {
  /** All that neither moves nor shines. */
  readonly body: Object3D;
  readonly wheels: readonly Wheel[];
  /** What turns at a joint, by the joint's key; looking up is positive. */
  readonly joints: Readonly<Record<string, Object3D>>;
  /** What shines, by the LED's key. */
  readonly lights: Readonly<Record<string, readonly Mesh[]>>;
  readonly face: Face | null;
  /** Its outline on the floor. */
  readonly outline: readonly XY[];
}

/** A robot on the floor, which takes the pose and the looks that telemetry tells. */
export class RobotModel {
  readonly object = new Group();
  /** From its middle to its farthest point, mm. */
  readonly reach: number;
  private last: Robot | null = null;

  constructor(
    private readonly look: Look,
    private readonly values: RobotValues,
  ) {
    const { body, wheels, joints } = look;
    const moving = [...wheels.map((wheel) => wheel.object), ...Object.values(joints)];
    for (const part of [body, shadows([look.outline]), ...moving]) this.object.add(part);
    this.reach = Math.max(...look.outline.map(([x, y]) => Math.hypot(x, y)));
    for (const lights of Object.values(look.lights)) {
      for (const light of lights) light.material = new MeshBasicMaterial({ color: LED_OFF });
    }
  }

  /** As it was shown last. */
  get pose(): Robot {
    return this.last ?? { name: "", x: 0, y: 0, heading: 0 };
  }

  show(robot: Robot): void {
    this.roll(robot);
    this.last = robot;
    place(this.object, robot);
    for (const [key, part] of Object.entries(this.look.joints)) {
      part.rotation.y = -radians(robot.joints?.[key] ?? 0);
    }
    this.shine(robot);
    if (this.look.face) this.look.face.show(robot.emotion ?? "none");
  }

  dispose(): void {
    this.look.face?.dispose();
  }

  /** Turn the wheels by the way that they have come. */
  private roll(robot: Robot): void {
    if (!this.last) return;
    const [dx, dy] = [robot.x - this.last.x, robot.y - this.last.y];
    const heading = radians(robot.heading);
    const advance = dx * Math.cos(heading) - dy * Math.sin(heading);
    const turn = radians(wrapped(robot.heading - this.last.heading)) * (this.values.wheels.track / 2);
    for (const wheel of this.look.wheels) wheel.roll(wheel.left ? advance + turn : advance - turn);
  }

  private shine(robot: Robot): void {
    for (const [slot, lights] of Object.entries(this.look.lights)) {
      const [red, green, blue] = robot.leds?.[slot] ?? [0, 0, 0];
      const dark = red + green + blue === 0;
      for (const light of lights) {
        const { color } = light.material as MeshBasicMaterial;
        if (dark) color.set(LED_OFF);
        else color.setStyle(`rgb(${red},${green},${blue})`);
      }
    }
  }
}
