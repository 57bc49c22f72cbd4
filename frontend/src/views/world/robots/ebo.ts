/** EBO: round and orange, with a head that nods and a face on it. */

import { Group } from "three";

import { css } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { circle } from "../scenery/shadows";
import { cylinder, Parts, roundedBox, turned } from "../scenery/solids";
import { Face } from "./face";
import type { Look } from "./model";
import { addWindows } from "./sensors";
import { Wheel } from "./wheel";

const DARK = "#2b303a";
const EAR = "#c75f12";
const HEAD = { x: 24, z: 88, length: 46, width: 88, height: 52 };

export function ebo(robot: RobotValues): Look {
  const { radius, track } = { radius: robot.wheels.radius, track: robot.wheels.track };
  const reach = robot.body.radius ?? 75;
  const face = new Face(76, 40, "#8fe3ff");
  return {
    body: shell(robot, reach),
    wheels: [track / 2, -track / 2].map((y) => new Wheel(y, radius, 16, { tyre: DARK, hub: "#f7d9b5" })),
    joints: { CAMERA: head(css(robot.body.colour), face) },
    lights: {},
    face,
    outline: circle(0, 0, reach),
  };
}

function shell(robot: RobotValues, reach: number) {
  const parts = new Parts().add(cylinder(reach - 22, 34), DARK, 0, 0, 25);
  const profile: [number, number][] = [
    [0, 36],
    [reach - 4, 36],
    [reach, 40],
    [reach, 56],
    [reach - 3, 64],
    [reach - 12, 70],
    [0, 72],
  ];
  parts.add(turned(profile, 48), css(robot.body.colour));
  parts.add(
    turned(
      [
        [reach + 0.6, 43],
        [reach + 0.6, 55],
      ],
      48,
    ),
    "#fff1df",
  );
  addWindows(parts, robot, 49);
  // A short tail, which marks the back.
  parts.add(cylinder(9, 14, 20), EAR, 22 - reach, 0, 76);
  parts.add(cylinder(16, 14, 24), DARK, HEAD.x, 0, 74);
  return parts.mesh();
}

function head(colour: string, face: Face): Group {
  const group = new Group();
  group.position.set(HEAD.x, 0, HEAD.z);
  const parts = new Parts().add(roundedBox(HEAD.length, HEAD.width, HEAD.height, 14), colour);
  parts.add(roundedBox(4, 82, 46, 2), DARK, HEAD.length / 2 - 1);
  for (const side of [1, -1]) parts.add(roundedBox(22, 10, 26, 5), EAR, -2, side * (HEAD.width / 2 + 2), 0);
  // The camera, above the screen.
  parts.add(roundedBox(8, 14, 8, 3), DARK, HEAD.length / 2 - 3, 0, HEAD.height / 2);
  face.mesh.position.x = HEAD.length / 2 + 1.2;
  group.add(parts.mesh(), face.mesh);
  return group;
}
