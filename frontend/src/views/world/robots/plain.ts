/** A robot without a model, drawn from its description. */

import { Group, Mesh, type Object3D } from "three";

import { friendly } from "../scenery/colours";
import type { RobotValues, XY } from "../scenery/description";
import { circle, rectangle } from "../scenery/shadows";
import { COAT, cylinder, drum, Parts, roundedBox } from "../scenery/solids";
import { Face } from "./face";
import type { Look } from "./model";
import { addWindows } from "./sensors";
import { Wheel } from "./wheel";

const DARK = "#2b3144";
const GROUND_CLEARANCE = 8;

export function plain(robot: RobotValues): Look {
  const { track, radius } = robot.wheels;
  const lights = lightsOf(robot);
  const face = robot.display?.kind === "screen" ? new Face(...screenSize(robot), "#5ef0ff") : null;
  const width = Math.max(6, radius * 0.4);
  const body = new Group();
  body.add(hull(robot), ...Object.values(lights).flat());
  return {
    body,
    wheels: [track / 2, -track / 2].map((y) => new Wheel(y, radius, width, { tyre: DARK, hub: "#ffffff" })),
    joints: { ...arms(robot), ...heads(robot, face, body) },
    lights,
    face,
    outline: outlineOf(robot),
  };
}

function outlineOf({ body }: RobotValues): XY[] {
  if (body.shape === "disc") return circle(0, 0, body.radius ?? 50);
  return rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 100, body.width ?? 100);
}

function frontOf({ body }: RobotValues): number {
  return body.shape === "disc" ? (body.radius ?? 50) : body.offset + (body.length ?? 100) / 2;
}

function hull(robot: RobotValues): Mesh {
  const { body } = robot;
  const tall = Math.max(4, body.height - GROUND_CLEARANCE);
  const parts = new Parts();
  const shape =
    body.shape === "disc"
      ? drum(body.radius ?? 50, tall, 14)
      : roundedBox(body.length ?? 100, body.width ?? 100, tall, 12);
  const [x, z] = [body.shape === "disc" ? 0 : body.offset, GROUND_CLEARANCE + tall / 2];
  parts.add(shape, friendly(body.colour), x, 0, z);
  addWindows(parts, robot, Math.min(body.height * 0.6, 50), 14, Math.min(9, tall / 2));
  // A triangle on top points ahead.
  const front = frontOf(robot);
  parts.add(cylinder(front * 0.22, 2, 3).rotateZ(Math.PI / 2), "#ffffff", front * 0.55, 0, body.height + 0.6);
  return parts.mesh(COAT);
}

function screenSize({ body }: RobotValues): [number, number] {
  const wide = body.shape === "disc" ? (body.radius ?? 50) : (body.width ?? 100) * 0.7;
  return [wide, Math.min(wide * 0.6, Math.max(12, body.height * 0.5))];
}

/** The mounts of the cameras; the first one that tilts also has the face. */
function heads(robot: RobotValues, face: Face | null, body: Group): Record<string, Object3D> {
  const found: Record<string, Object3D> = {};
  const [width, height] = screenSize(robot);
  for (const { joint, x, z } of robot.camera) {
    const lens = new Parts()
      .add(roundedBox(10, 14, 12, 4), DARK)
      .add(cylinder(4, 3).rotateY(Math.PI / 2), "#6fb1d8", 6);
    const carrier = new Group().add(lens.mesh());
    carrier.position.set(x, 0, z);
    if (joint) found[joint] = carrier;
    else body.add(carrier);
  }
  if (!face) return found;
  const frame = new Group().add(new Parts().add(roundedBox(6, width + 8, height + 8, 4), DARK, -4).mesh(), face.mesh);
  const [carrier] = Object.values(found);
  frame.position.set(
    carrier ? 0 : frontOf(robot) * 0.5,
    0,
    carrier ? height / 2 + 12 : robot.body.height + height / 2 + 4,
  );
  (carrier ?? body).add(frame);
  return found;
}

function arms(robot: RobotValues): Record<string, Object3D> {
  const tilting = new Set(robot.camera.map(({ joint }) => joint));
  const others = robot.joint.filter(({ key }) => !tilting.has(key));
  return Object.fromEntries(others.map(({ key }, i) => [key, arm(robot, i)]));
}

function arm(robot: RobotValues, index: number): Group {
  const length = frontOf(robot) * 0.9;
  const group = new Group().add(
    new Parts()
      .add(roundedBox(length, 10, 10, 3), DARK, length / 2)
      .add(roundedBox(12, 18, 18, 5), "#e9ecef", length)
      .mesh(),
  );
  group.position.set(frontOf(robot) * 0.4, (index % 2 ? -1 : 1) * 14 * Math.ceil((index + 1) / 2), robot.body.height);
  return group;
}

function lightsOf(robot: RobotValues): Record<string, Mesh[]> {
  const { length } = robot.led;
  return Object.fromEntries(
    robot.led.map(({ slot }, i) => {
      const mesh = new Mesh(roundedBox(8, 8, 4, 2));
      mesh.position.set(-frontOf(robot) * 0.4, (i - (length - 1) / 2) * -12, robot.body.height + 1);
      return [slot, [mesh]];
    }),
  );
}
