/** LEGO EV3: a grey brick between two big wheels, with ultrasonic eyes. */

import { Group } from "three";
import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { rectangle } from "../scenery/shadows";
import { ball, COAT, cylinder, drum, Parts, roundedBox } from "../scenery/solids";
import { Lcd } from "./lcd";
import type { Look } from "./model";
import { Wheel } from "./wheel";

const LIGHT = "#eef1f6";
const DARK = "#4a5468";
const BLACK = "#20262f";
const RED = "#e5322d";
const STEEL = "#c3cad8";
const BUTTON = "#dfe4ee";

export function ev3(robot: RobotValues): Look {
  const { wheels, body } = robot;
  const [coat, matt] = [new Parts(), new Parts()];
  addBrick(coat, friendly(body.colour));
  addEyes(coat);
  addFrame(matt, wheels.track);
  const lcd = new Lcd(50, 36);
  lcd.mesh.position.set(22, 0, 100.2);
  return {
    body: new Group().add(coat.mesh(COAT), matt.mesh(), lcd.mesh),
    wheels: [1, -1].map((side) => new Wheel((side * wheels.track) / 2, wheels.radius, 26, { tyre: BLACK, hub: LIGHT })),
    joints: {},
    lights: {},
    face: lcd,
    outline: rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 180, body.width ?? 150),
  };
}

/** The brick is above the axle, with screen and buttons on top. */
function addBrick(parts: Parts, colour: string): void {
  parts.add(roundedBox(116, 74, 46, 9), LIGHT, -4, 0, 74);
  parts.add(roundedBox(118, 76, 16, 6), colour, -4, 0, 60);
  parts.add(roundedBox(48, 60, 4, 2), DARK, 22, 0, 97);
  parts.add(roundedBox(38, 52, 4, 1), "#b9cdb4", 22, 0, 98);
  parts.add(roundedBox(40, 56, 4, 2), DARK, -34, 0, 97);
  parts.add(roundedBox(14, 14, 5, 3), BUTTON, -34, 0, 99);
  for (const [x, y] of [
    [15, 0],
    [-15, 0],
    [0, 20],
    [0, -20],
  ] as const) {
    parts.add(roundedBox(9, 13, 5, 2.4), "#8d99ae", -34 + x, y, 98);
  }
}

/** Motors, beams and the ball caster at the back. */
function addFrame(parts: Parts, track: number): void {
  parts.add(roundedBox(70, track - 34, 26, 6), DARK, -6, 0, 36);
  for (const side of [1, -1]) parts.add(roundedBox(156, 9, 14, 3), RED, 8, side * 34, 46);
  parts.add(ball(13), STEEL, -54, 0, 13);
  // The colour sensor points at the floor; the bumper is the front bar.
  parts.add(roundedBox(24, 24, 34, 4), LIGHT, 80, 0, 26);
  parts.add(roundedBox(16, 16, 4, 2), RED, 80, 0, 8);
  parts.add(roundedBox(8, 60, 14, 4), RED, 104, 0, 24);
  parts.add(roundedBox(22, 12, 10, 3), DARK, 92, 0, 26);
}

function addEyes(parts: Parts): void {
  parts.add(roundedBox(28, 70, 32, 10), LIGHT, 84, 0, 66);
  for (const y of [17, -17]) {
    parts.add(drum(15, 12, 3).rotateY(Math.PI / 2), LIGHT, 97, y, 66);
    parts.add(cylinder(11, 13).rotateY(Math.PI / 2), "#0b1020", 97.4, y, 66);
    parts.add(cylinder(5, 13.6).rotateY(Math.PI / 2), "#ff5d5d", 97.8, y, 66);
  }
}
