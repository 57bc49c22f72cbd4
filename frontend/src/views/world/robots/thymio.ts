/** Thymio: white, round in front, and lit in one colour. */

import { Group, Mesh, Path, Shape } from "three";

import { friendly } from "../scenery/colours";
import type { RobotValues, XY } from "../scenery/description";
import { COAT, drum, Parts, plate, roundedBox } from "../scenery/solids";
import type { Look } from "./model";
import { addWindows } from "./sensors";
import { Wheel } from "./wheel";

const GREY = "#c9d1e0";
const DARK = "#39425a";
const MIDDLE = "#ff8a1f";
/** The length of the round part. */
const ROUNDING = 28;

export function thymio(robot: RobotValues): Look {
  const { radius, track } = robot.wheels;
  const wheels = [track / 2 + 6, -track / 2 - 6].map(
    (y) => new Wheel(y, radius, 11, { tyre: "#222938", hub: "#dfe5f0" }),
  );
  const lights = lightsOf(robot);
  const body = hull(robot);
  for (const light of Object.values(lights).flat()) body.add(light);
  return { body, wheels, joints: {}, lights, face: null, outline: outlineOf(robot) };
}

interface Extent {
  back: number;
  front: number;
  side: number;
}

function extentOf({ body }: RobotValues): Extent {
  const half = (body.length ?? 110) / 2;
  return { back: body.offset - half, front: body.offset + half, side: (body.width ?? 112) / 2 };
}

/** The outline from above: straight at the back, a flat curve in front. */
function shapeOf({ back, front, side }: Extent, inset = 0): Shape {
  const [b, f, s] = [back + inset, front - inset, side - inset];
  const shape = new Shape();
  shape.moveTo(b, -s).lineTo(f - ROUNDING, -s);
  shape.bezierCurveTo(f - 9, -s * 0.72, f, -s * 0.4, f, 0).bezierCurveTo(f, s * 0.4, f - 9, s * 0.72, f - ROUNDING, s);
  shape.lineTo(b, s).closePath();
  return shape;
}

function outlineOf(robot: RobotValues): XY[] {
  return shapeOf(extentOf(robot))
    .getPoints(6)
    .slice(0, -1)
    .map(({ x, y }): XY => [x, y]);
}

function hull(robot: RobotValues): Group {
  const extent = extentOf(robot);
  const { height } = robot.body;
  const matt = new Parts().add(plate(shapeOf(extent, 8), 14), DARK, 0, 0, 4);
  addWindows(matt, robot, 33, 14, 9);
  const coat = new Parts();
  coat.add(
    plate(shapeOf({ ...extent, side: extent.side - 5 }), height - 14, 10),
    friendly(robot.body.colour),
    0,
    0,
    14,
  );
  addButtons(coat, height);
  return new Group().add(coat.mesh(COAT), matt.mesh());
}

/** The five buttons on top: a round one between four arrows. */
function addButtons(parts: Parts, height: number): void {
  parts.add(drum(7, 4, 2), MIDDLE, 30, 0, height + 1);
  for (const [x, y] of [
    [17, 0],
    [-17, 0],
    [0, 17],
    [0, -17],
  ] as const) {
    parts.add(roundedBox(9, 9, 4, 2).rotateZ(Math.PI / 4), GREY, 30 + x, y, height + 0.6);
  }
}

function lightsOf(robot: RobotValues): Record<string, Mesh[]> {
  const extent = extentOf(robot);
  const places: Record<string, () => Mesh> = {
    Up: () => ring(extent, robot.body.height),
    Left: () => strip(extent, 1),
    Right: () => strip(extent, -1),
  };
  const known = robot.led.filter(({ slot }) => slot in places);
  return Object.fromEntries(known.map(({ slot }) => [slot, [(places[slot] as () => Mesh)()]]));
}

/** A ring of light around the buttons. */
function ring({ back, front, side }: Extent, height: number): Mesh {
  const outer = shapeOf({ back: back + 10, front: front - 12, side: side - 18 });
  outer.holes.push(new Path(shapeOf({ back: back + 18, front: front - 20, side: side - 27 }).getPoints(10)));
  const mesh = new Mesh(plate(outer, 2.4, 0.5));
  mesh.position.z = height - 0.4;
  return mesh;
}

function strip({ back, front, side }: Extent, sign: number): Mesh {
  const mesh = new Mesh(roundedBox((front - back) * 0.5, 3, 7, 1));
  mesh.position.set(back + (front - back) * 0.48, sign * (side - 4.5), 37);
  return mesh;
}
