/** EBO: round and orange, with a head that nods and a face on it. */

import { Color, Group } from "three";

import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { circle } from "../scenery/shadows";
import { COAT, drum, Parts, roundedBox } from "../scenery/solids";
import { Face } from "./face";
import type { Look } from "./model";
import { addWindows } from "./sensors";
import { Wheel } from "./wheel";

const DARK = "#2b3144";
const SCREEN = "#0b1020";
const CREAM = "#fff3e2";
const HEAD = { x: 10, z: 90, length: 50, width: 78, height: 54 };
/** How far the wheels stand out. */
const OUT = 6;

export function ebo(robot: RobotValues): Look {
  const reach = robot.body.radius ?? 75;
  const face = new Face(64, 38, "#5ef0ff");
  const side = reach - OUT;
  return {
    body: shell(robot, reach - OUT),
    wheels: [side, -side].map((y) => new Wheel(y, robot.wheels.radius, 16, { tyre: "#222938", hub: "#ffffff" })),
    joints: { CAMERA: head(friendly(robot.body.colour), face) },
    lights: {},
    face,
    outline: circle(0, 0, reach),
  };
}

function shell(robot: RobotValues, radius: number): Group {
  const colour = friendly(robot.body.colour);
  const coat = new Parts().add(drum(radius, 40, 15), colour, 0, 0, 32);
  coat.add(drum(radius + 1.2, 11, 4), CREAM, 0, 0, 31);
  coat.add(drum(radius - 10, 16, 7), colour, 0, 0, 55);
  // A short tail, which marks the back.
  coat.add(drum(11, 20, 4), dark(colour), 16 - radius, 0, 68);
  const matt = new Parts().add(drum(30, 18, 5), DARK, HEAD.x - 4, 0, 66);
  addWindows(matt, robot, 31, 15, 9);
  return new Group().add(coat.mesh(COAT), matt.mesh());
}

function dark(colour: string): string {
  return new Color(colour).multiplyScalar(0.55).getStyle();
}

function head(colour: string, face: Face): Group {
  const group = new Group();
  group.position.set(HEAD.x, 0, HEAD.z);
  const coat = new Parts().add(roundedBox(HEAD.length, HEAD.width, HEAD.height, 15), colour);
  for (const side of [1, -1]) coat.add(roundedBox(26, 13, 32, 6), dark(colour), -2, side * (HEAD.width / 2 + 2), 0);
  coat.add(roundedBox(8, 68, 43, 5), SCREEN, HEAD.length / 2 - 2);
  // The camera, above the screen.
  coat.add(roundedBox(13, 18, 11, 4), DARK, HEAD.length / 2 - 6, 0, HEAD.height / 2);
  face.mesh.position.x = HEAD.length / 2 + 2.2;
  group.add(coat.mesh(COAT), face.mesh);
  return group;
}
