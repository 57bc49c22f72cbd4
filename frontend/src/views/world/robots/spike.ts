/** LEGO SPIKE Prime: a white and yellow hub with a light matrix, between two blue wheels. */

import { CircleGeometry, Group, Mesh } from "three";
import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { rectangle } from "../scenery/shadows";
import { ball, COAT, cylinder, drum, Parts, roundedBox } from "../scenery/solids";
import { Lcd } from "./lcd";
import type { Look } from "./model";
import { Wheel } from "./wheel";

const WHITE = "#f4f6fa";
const DARK = "#3c4658";
const BLACK = "#20262f";
const TEAL = "#1aa7a1";
const MAGENTA = "#d6409f";
const STEEL = "#c3cad8";
/** The height of the hub's upper side, mm. */
const TOP = 92;

export function spike(robot: RobotValues): Look {
  const { wheels, body } = robot;
  const [coat, matt] = [new Parts(), new Parts()];
  addHub(coat, friendly(body.colour));
  addEyes(coat);
  addFrame(matt, wheels.track);
  const matrix = new Lcd(34, 34, { paper: BLACK, ink: WHITE });
  matrix.mesh.position.set(2, 0, TOP + 1.2);
  const status = new Mesh(new CircleGeometry(7, 24));
  status.position.set(-32, 0, TOP + 2.2);
  return {
    body: new Group().add(coat.mesh(COAT), matt.mesh(), matrix.mesh, status),
    wheels: [1, -1].map((side) => new Wheel((side * wheels.track) / 2, wheels.radius, 14, { tyre: BLACK, hub: TEAL })),
    joints: {},
    lights: { Status: [status] },
    face: matrix,
    outline: rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 170, body.width ?? 140),
  };
}

/** The flat hub on top of the motors, its matrix and buttons facing up. */
function addHub(parts: Parts, colour: string): void {
  parts.add(roundedBox(90, 58, 26, 6), WHITE, -4, 0, TOP - 13);
  parts.add(roundedBox(92, 60, 12, 4), colour, -4, 0, TOP - 26);
  parts.add(roundedBox(44, 44, 3, 3), DARK, 2, 0, TOP - 0.6);
  parts.add(drum(10, 4, 1.5), DARK, -32, 0, TOP);
  for (const y of [18, -18]) parts.add(roundedBox(8, 12, 3, 1.5), STEEL, -32, y, TOP);
}

/** Motors, beams, the ball behind, the colour sensor towards the floor and the force sensor in front. */
function addFrame(parts: Parts, track: number): void {
  for (const side of [1, -1]) {
    parts.add(roundedBox(58, 30, 30, 6), WHITE, -2, side * (track / 2 - 30), 36);
    parts.add(roundedBox(150, 8, 12, 2), TEAL, 12, side * 30, 56);
  }
  parts.add(ball(12), STEEL, -54, 0, 12);
  parts.add(roundedBox(22, 22, 32, 4), WHITE, 75, 0, 26);
  parts.add(roundedBox(14, 14, 4, 2), BLACK, 75, 0, 9);
  parts.add(roundedBox(22, 20, 18, 4), WHITE, 88, 0, 40);
  parts.add(roundedBox(6, 60, 14, 3), MAGENTA, 99, 0, 28);
}

function addEyes(parts: Parts): void {
  parts.add(roundedBox(24, 54, 26, 8), WHITE, 82, 0, 66);
  for (const y of [13, -13]) {
    parts.add(drum(12, 10, 3).rotateY(Math.PI / 2), DARK, 93, y, 66);
    parts.add(cylinder(8, 11).rotateY(Math.PI / 2), BLACK, 93.6, y, 66);
  }
}
