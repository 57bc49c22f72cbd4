/** iRobot's Create 3: a grey disc with a bumper in front, seven dark windows and a ring of lights. */

import { Group, Mesh, RingGeometry } from "three";
import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { circle } from "../scenery/shadows";
import { COAT, drum, Parts, roundedBox } from "../scenery/solids";
import type { Look } from "./model";
import { addWindows } from "./sensors";
import { Wheel } from "./wheel";

const WHITE = "#f4f6fa";
const DARK = "#3c4658";
const BLACK = "#20262f";
const GREEN = "#6bbf59";
/** Corners of its outline. */
const CORNERS = 36;

export function create3(robot: RobotValues): Look {
  const { wheels, body } = robot;
  const radius = body.radius ?? 171;
  const coat = new Parts();
  coat.add(drum(radius, 66, 6), DARK, 0, 0, 45);
  coat.add(drum(radius - 8, 12, 4), friendly(body.colour), 0, 0, body.height - 8);
  addFaceplate(coat, body.height);
  addWindows(coat, robot, 52, 12, 8);
  const ring = new Mesh(new RingGeometry(16, 22, 32));
  ring.position.set(60, 0, body.height + 1);
  return {
    body: new Group().add(coat.mesh(COAT), ring),
    wheels: [1, -1].map((side) => new Wheel((side * wheels.track) / 2, wheels.radius, 18, { tyre: BLACK, hub: WHITE })),
    joints: {},
    lights: { Up: [ring] },
    face: null,
    outline: circle(0, 0, radius, CORNERS),
  };
}

/** The plate with its holes, the button between its two small ones, and the handle behind. */
function addFaceplate(parts: Parts, height: number): void {
  parts.add(drum(14, 3, 1), GREEN, 60, 0, height - 0.5);
  for (const y of [37, -37]) parts.add(drum(8, 3, 1), WHITE, 60, y, height - 1);
  for (const x of [0, -40, -80]) {
    for (const y of [-60, -20, 20, 60]) parts.add(drum(4, 2, 0.5), BLACK, x, y, height - 1);
  }
  parts.add(roundedBox(16, 80, 4, 2), BLACK, -125, 0, height - 2);
}
