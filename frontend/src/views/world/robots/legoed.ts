/** LEGO Education's car: a Double Motor between two blue wheels, its sensor in front, the arm on top. */

import { CircleGeometry, Group, Mesh } from "three";
import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { rectangle } from "../scenery/shadows";
import { ball, COAT, cylinder, drum, Parts, roundedBox } from "../scenery/solids";
import type { Look } from "./model";
import { Wheel } from "./wheel";

const WHITE = "#f4f6fa";
const BLACK = "#20262f";
const BLUE = "#2f80ed";
const YELLOW = "#f7c948";
const STEEL = "#c3cad8";
/** The height of the Double Motor's upper side, mm. */
const TOP = 58;
/** The axle of the Single Motor: forward and up, mm. */
const ARM = { x: 40, z: TOP + 14 };

export function legoed(robot: RobotValues): Look {
  const { wheels, body } = robot;
  const [coat, matt, beam] = [new Parts(), new Parts(), new Parts()];
  addMotor(coat, friendly(body.colour));
  addFrame(matt);
  beam.add(roundedBox(56, 8, 8, 3), YELLOW, 24, -20, 0);
  const arm = beam.mesh();
  arm.position.set(ARM.x, 0, ARM.z);
  const status = new Mesh(new CircleGeometry(6, 24));
  status.position.set(-26, 0, TOP + 1.2);
  return {
    body: new Group().add(coat.mesh(COAT), matt.mesh(), status),
    wheels: [1, -1].map((side) => new Wheel((side * wheels.track) / 2, wheels.radius, 14, { tyre: BLACK, hub: BLUE })),
    joints: { ARM: arm },
    lights: { Status: [status] },
    face: null,
    outline: rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 150, body.width ?? 105),
  };
}

/** The flat Double Motor between the wheels, and the Single Motor on top of it. */
function addMotor(parts: Parts, colour: string): void {
  parts.add(roundedBox(88, 56, 34, 8), WHITE, -4, 0, TOP - 17);
  parts.add(roundedBox(90, 58, 8, 4), colour, -4, 0, TOP - 18);
  parts.add(drum(9, 3, 1), STEEL, -26, 0, TOP);
  parts.add(roundedBox(46, 30, 26, 6), WHITE, ARM.x - 12, 4, ARM.z);
  parts.add(roundedBox(48, 32, 6, 3), colour, ARM.x - 12, 4, ARM.z);
  parts.add(cylinder(6, 8), BLACK, ARM.x, -14, ARM.z);
}

/** Beams, the ball behind, and the colour sensor towards the floor. */
function addFrame(parts: Parts): void {
  for (const side of [1, -1]) parts.add(roundedBox(126, 8, 8, 2), YELLOW, 18, side * 22, TOP - 24);
  parts.add(ball(12), STEEL, -48, 0, 12);
  parts.add(roundedBox(24, 30, 40, 6), WHITE, 75, 0, 28);
  parts.add(roundedBox(16, 16, 4, 2), BLACK, 75, 0, 7);
}
