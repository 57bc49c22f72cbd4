/** The model of a robot: the parts common to all kinds. */

import { Box3, Group, type Mesh, MeshBasicMaterial, type Object3D, type Sprite } from "three";
import type { Robot } from "../../../protocol/messages";
import type { RobotValues, XY } from "../scenery/description";
import { radians, wrapped } from "../scenery/geometry";
import { shadows } from "../scenery/shadows";
import { place } from "../scenery/things";
import { Bubble } from "./bubble";
import type { Wheel } from "./wheel";

const LED_OFF = "#aab3c5";

/** A screen of a robot. */
export interface Screen {
  show(emotion: string, text: string): void;
  /** Close or open its eyes, if it has any. */
  blink?(closed: boolean): void;
  dispose(): void;
}

/** The appearance of one kind of robot. Positions are in mm: forward, left, up. */
export interface Look {
  /** The parts that neither move nor light up. */
  readonly body: Object3D;
  readonly wheels: readonly Wheel[];
  /** The parts that turn at joints, by the joint's key; up is positive. */
  readonly joints: Readonly<Record<string, Object3D>>;
  /** The lights, by the LED's key. */
  readonly lights: Readonly<Record<string, readonly Mesh[]>>;
  /** What shows emotions and texts. */
  readonly face: Screen | null;
  /** Its outline on the floor. */
  readonly outline: readonly XY[];
}

/** Where a robot's camera is, mm, and how far it looks up, degrees. */
export interface EyePose {
  readonly ahead: number;
  readonly height: number;
  readonly up: number;
}

/** A robot on the floor with the pose and state of telemetry. */
export class RobotModel {
  readonly object = new Group();
  /** The distance from its centre to its farthest point, mm. */
  readonly reach: number;
  /** mm. */
  readonly height: number;
  private last: Robot | null = null;
  private readonly bubble: Bubble;

  constructor(
    private readonly look: Look,
    private readonly values: RobotValues,
  ) {
    const { body, wheels, joints } = look;
    const moving = [...wheels.map((wheel) => wheel.object), ...Object.values(joints)];
    for (const part of [body, shadows([look.outline]), ...moving]) this.object.add(part);
    this.bubble = new Bubble(values.body.height);
    this.height = new Box3().setFromObject(this.object).max.z;
    this.object.add(this.bubble.sprite);
    this.reach = Math.max(...look.outline.map(([x, y]) => Math.hypot(x, y)));
    for (const lights of Object.values(look.lights)) {
      for (const light of lights) light.material = new MeshBasicMaterial({ color: LED_OFF, toneMapped: false });
    }
  }

  /** The state shown last. */
  get pose(): Robot {
    return this.last ?? { name: "", x: 0, y: 0, heading: 0 };
  }

  /** Where its camera is, or its front if it has none. */
  get eye(): EyePose {
    const [camera] = this.values.camera;
    if (!camera) return { ahead: this.reach, height: this.values.body.height * 0.8, up: 0 };
    const up = camera.pitch + (camera.joint ? (this.pose.joints?.[camera.joint] ?? 0) : 0);
    return { ahead: camera.x, height: camera.z, up };
  }

  show(robot: Robot): void {
    this.roll(robot);
    this.last = robot;
    place(this.object, robot);
    for (const [key, part] of Object.entries(this.look.joints)) {
      part.rotation.y = -radians(robot.joints?.[key] ?? 0);
    }
    this.shine(robot);
    this.look.face?.show(robot.emotion ?? "none", robot.text ?? "");
    // A screen is small, and may face away: its text is above the robot, too.
    this.bubble.show(robot.text ?? "");
  }

  blink(closed: boolean): void {
    this.look.face?.blink?.(closed);
  }

  /** Put its name above it, below its texts. */
  label(plate: Sprite): void {
    this.object.add(plate);
    this.bubble.lift(plate.position.z + plate.scale.y / 2);
  }

  dispose(): void {
    this.look.face?.dispose();
    this.bubble.dispose();
  }

  /** Turn the wheels by the distance driven. */
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
