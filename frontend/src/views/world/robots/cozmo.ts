/** Cozmo: a small tractor on tracks, with a lift in front and big eyes on a screen. */

import { Group, Mesh, Path, Shape } from "three";

import { friendly } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { rectangle } from "../scenery/shadows";
import { COAT, drum, Parts, plate, roundedBox } from "../scenery/solids";
import { Face } from "./face";
import type { Look } from "./model";
import { Wheel } from "./wheel";

const DARK = "#2a3040";
const RED = "#ff5a3c";
const STEEL = "#c3cad8";
const SCREEN = "#0b1020";
const LIFT = { x: -14, z: 45, length: 66 };
const LED_PLACES: Readonly<Record<string, readonly [number, number]>> = {
  Front: [-14, 0],
  Center: [-23, 0],
  Rear: [-32, 0],
  Left: [-23, 11],
  Right: [-23, -11],
};

export function cozmo(robot: RobotValues): Look {
  const { body, wheels } = robot;
  const face = new Face(38, 25, "#5ef0ff");
  const lights = lightsOf(robot);
  const group = hull(robot);
  for (const light of Object.values(lights).flat()) group.add(light);
  const axles = [wheels.track / 2 + 3, -wheels.track / 2 - 3];
  const hubs = { tyre: DARK, hub: RED };
  return {
    body: group,
    wheels: [0, 34].flatMap((x) => axles.map((y) => new Wheel(y, wheels.radius - 2, 13, hubs, x - 8))),
    joints: { CAMERA: head(face), ARM: lift() },
    lights,
    face,
    outline: rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 95, body.width ?? 58),
  };
}

function hull(robot: RobotValues): Group {
  const colour = friendly(robot.body.colour);
  const coat = new Parts().add(roundedBox(76, 34, 27, 8), colour, -4, 0, 26);
  coat.add(roundedBox(44, 36, 16, 7), colour, -22, 0, 43);
  coat.add(roundedBox(20, 32, 13, 5), RED, -40, 0, 30);
  const matt = new Parts().add(roundedBox(34, 32, 4, 2), DARK, -23, 0, 50.5);
  for (const side of [1, -1]) {
    const middle = side * (robot.wheels.track / 2 + 3);
    const tread = plate(stadium(21, 15), 13, 1.5)
      .rotateX(Math.PI / 2)
      .translate(9, 6.5, 15);
    matt.add(tread, DARK, 0, middle, 0);
    for (let i = -3; i <= 3; i++) matt.add(roundedBox(4, 13, 2.4, 1), "#1b2030", 9 + i * 8, middle, 30);
    matt.add(drum(8, 7, 2).rotateX(Math.PI / 2), RED, LIFT.x, side * 20, LIFT.z);
  }
  return new Group().add(coat.mesh(COAT), matt.mesh());
}

/** A track's outline, hollow for its wheels. */
function stadium(half: number, radius: number): Shape {
  const shape = round(new Shape(), half, radius);
  shape.holes.push(round(new Path(), half, radius - 4));
  return shape;
}

function round<T extends Path>(path: T, half: number, radius: number): T {
  path.absarc(half, 0, radius, -Math.PI / 2, Math.PI / 2, false);
  path.absarc(-half, 0, radius, Math.PI / 2, (3 * Math.PI) / 2, false);
  return path;
}

function head(face: Face): Group {
  const group = new Group();
  group.position.set(2, 0, 52);
  const coat = new Parts().add(roundedBox(42, 50, 37, 10), "#f7f8fb", 8, 0, 7);
  coat.add(roundedBox(5, 43, 30, 5), SCREEN, 28, 0, 7);
  coat.add(roundedBox(24, 34, 5, 2.4), RED, 4, 0, 25.5);
  for (const side of [1, -1]) {
    coat.add(drum(9, 5, 2).rotateX(Math.PI / 2), STEEL, 2, side * 26, 5);
  }
  face.mesh.position.set(30.8, 0, 7);
  group.add(coat.mesh(COAT), face.mesh);
  return group;
}

/** The lift's two beams and its fork; level at 0 degrees of its joint. */
function lift(): Group {
  const group = new Group();
  group.position.set(LIFT.x, 0, LIFT.z);
  const parts = new Parts();
  for (const side of [1, -1]) {
    parts.add(roundedBox(LIFT.length, 4, 7, 2), STEEL, LIFT.length / 2, side * 26, 0);
    parts.add(roundedBox(9, 7, 18, 3), STEEL, LIFT.length + 3, side * 16, -10);
  }
  parts.add(roundedBox(7, 58, 14, 3), STEEL, LIFT.length, 0, -5);
  group.add(parts.mesh(COAT));
  return group;
}

function lightsOf(robot: RobotValues): Record<string, Mesh[]> {
  return Object.fromEntries(
    robot.led.flatMap(({ slot }) => {
      const place = LED_PLACES[slot];
      return place ? [[slot, [light(...place)]]] : [];
    }),
  );
}

function light(x: number, y: number): Mesh {
  const mesh = new Mesh(roundedBox(7, 8, 4, 2));
  mesh.position.set(x, y, 53.5);
  return mesh;
}
