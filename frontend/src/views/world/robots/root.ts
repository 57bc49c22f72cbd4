/** iRobot's Root: a flat white hexagon with a cross of lights around its marker, and a yellow nose. */

import { Group, Mesh, PlaneGeometry, Shape } from "three";
import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { rectangle } from "../scenery/shadows";
import { ball, COAT, drum, Parts, plate, roundedBox } from "../scenery/solids";
import type { Look } from "./model";
import { Wheel } from "./wheel";

const BLACK = "#20262f";
const DARK = "#3c4658";
const YELLOW = "#f2c230";
const BLUE = "#2b62d9";
const EYE = "#dff1ff";
/** The height of its upper side, mm. */
const TOP = 45;
/** From its middle to a corner of its base and of its lid, mm. */
const BASE = 75;
const LID = 71;

export function root(robot: RobotValues): Look {
  const { wheels, body } = robot;
  const coat = new Parts();
  coat.add(plate(hexagon(BASE), 26, 6), BLACK, 0, 0, 6);
  coat.add(plate(hexagon(LID), 13, 5), friendly(body.colour), 0, 0, TOP - 13);
  addFace(coat);
  addMarker(coat);
  const cross = [light(24, 3, 32), light(24, 3, -32), light(3, 34, 0, 34), light(3, 34, 0, -34)];
  return {
    body: new Group().add(coat.mesh(COAT), ...cross),
    wheels: [1, -1].map((side) => new Wheel((side * wheels.track) / 2, wheels.radius, 12, { tyre: DARK, hub: BLACK })),
    joints: {},
    lights: { Up: cross },
    face: null,
    outline: rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 149, body.width ?? 134),
  };
}

/** A hexagon that points forward. */
function hexagon(radius: number): Shape {
  const shape = new Shape();
  for (let i = 0; i < 6; i++) {
    const angle = (i * Math.PI) / 3;
    const [x, y] = [radius * Math.cos(angle), radius * Math.sin(angle) * 1.03];
    if (i === 0) shape.moveTo(x, y);
    else shape.lineTo(x, y);
  }
  return shape.closePath();
}

/** Its nose in front, and an eye on each side of it. */
function addFace(parts: Parts): void {
  parts.add(roundedBox(8, 14, 8, 3), YELLOW, 70, 0, TOP - 10);
  for (const y of [20, -20]) parts.add(ball(5), EYE, 62, y, TOP - 10);
}

/** The marker in the middle, upright. */
function addMarker(parts: Parts): void {
  parts.add(drum(12, 4, 1.5), DARK, 0, 0, TOP + 1);
  parts.add(drum(7, 60, 1.5), BLUE, 0, 0, TOP + 24);
  parts.add(drum(5, 12, 1.5), BLACK, 0, 0, TOP + 58);
}

/** A bar of the cross of lights. */
function light(length: number, width: number, x: number, y = 0): Mesh {
  const bar = new Mesh(new PlaneGeometry(length, width));
  bar.position.set(x, y, TOP + 3);
  return bar;
}
