/** Cozmo: a small tractor on tracks, with a lift in front and big eyes on a screen. */

import { Group, Mesh, Path, Shape } from "three";

import { css } from "../scenery/colours";
import type { RobotValues } from "../scenery/description";
import { rectangle } from "../scenery/shadows";
import { Parts, plate, roundedBox, wheelDisc } from "../scenery/solids";
import { Face } from "./face";
import type { Look } from "./model";
import { Wheel } from "./wheel";

const DARK = "#3b4048";
const RED = "#d8402f";
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
  const face = new Face(36, 24, "#57d8ff");
  const lights = lightsOf(robot);
  const group = new Group();
  group.add(hull(robot), ...Object.values(lights).flat());
  const axles = [wheels.track / 2, -wheels.track / 2];
  const hubs = { tyre: "#8b939e", hub: "#e9ecef" };
  return {
    body: group,
    wheels: [0, 34].flatMap((x) => axles.map((y) => new Wheel(y, wheels.radius - 2, 11, hubs, x - 8))),
    joints: { CAMERA: head(face), ARM: lift() },
    lights,
    face,
    outline: rectangle({ x: body.offset, y: 0, heading: 0 }, body.length ?? 95, body.width ?? 58),
  };
}

function hull(robot: RobotValues): Mesh {
  const colour = css(robot.body.colour);
  const parts = new Parts().add(roundedBox(72, 32, 26, 6), colour, -4, 0, 24);
  parts.add(roundedBox(40, 34, 16, 6), colour, -22, 0, 42);
  parts.add(roundedBox(30, 30, 4, 2), DARK, -23, 0, 50);
  parts.add(roundedBox(6, 20, 10, 3), DARK, -42, 0, 28);
  for (const side of [1, -1]) {
    const tread = plate(stadium(20, 14), 10, 1)
      .rotateX(Math.PI / 2)
      .translate(9, 5, 14.5);
    parts.add(tread, DARK, 0, side * (robot.wheels.track / 2), 0);
    parts.add(wheelDisc(7, 6, 20), RED, LIFT.x, side * 19, LIFT.z);
  }
  return parts.mesh();
}

/** A track's outline, hollow for its wheels. */
function stadium(half: number, radius: number): Shape {
  const shape = round(new Shape(), half, radius);
  shape.holes.push(round(new Path(), half, radius - 3.5));
  return shape;
}

function round<T extends Path>(path: T, half: number, radius: number): T {
  path.absarc(half, 0, radius, -Math.PI / 2, Math.PI / 2, false);
  path.absarc(-half, 0, radius, Math.PI / 2, (3 * Math.PI) / 2, false);
  return path;
}

function head(face: Face): Group {
  const group = new Group();
  group.position.set(2, 0, 50);
  const parts = new Parts().add(roundedBox(38, 44, 34, 8), "#f4f5f6", 8, 0, 6);
  parts.add(roundedBox(4, 40, 28, 2), "#1b2028", 26, 0, 5);
  parts.add(roundedBox(10, 48, 12, 4), DARK, -2, 0, 2);
  face.mesh.position.set(28.4, 0, 6);
  group.add(parts.mesh(), face.mesh);
  return group;
}

/** The lift's two beams and its fork; level at 0 degrees of its joint. */
function lift(): Group {
  const group = new Group();
  group.position.set(LIFT.x, 0, LIFT.z);
  const parts = new Parts();
  for (const side of [1, -1]) {
    parts.add(roundedBox(LIFT.length, 4, 7, 2), DARK, LIFT.length / 2, side * 26, 0);
    parts.add(roundedBox(8, 6, 16, 2), RED, LIFT.length + 3, side * 16, -10);
  }
  parts.add(roundedBox(6, 56, 12, 3), "#e9ecef", LIFT.length, 0, -5);
  group.add(parts.mesh());
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
  const mesh = new Mesh(roundedBox(6, 7, 3, 1.4));
  mesh.position.set(x, y, 53);
  return mesh;
}
