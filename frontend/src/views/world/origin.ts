/** Where on the robot a value is measured: rings at its ground sensors, or one around the whole robot. */

import { type BufferGeometry, Mesh, MeshBasicMaterial, RingGeometry } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

import { MARKS } from "./scenery/colours";
import type { RobotValues } from "./scenery/description";

/** mm over the floor, of a ring's width, and of its radius around a sensor and beyond the robot. */
const HEIGHT = 4;
const WIDTH = 8;
const AROUND = 18;
const BEYOND = 22;
/** Over the trail and things. */
const ORDER = 7;

/** @param reach of the robot, mm. */
export function origin(device: string, robot: RobotValues, reach: number): Mesh<BufferGeometry, MeshBasicMaterial> {
  const sensors = device === "GroundSensors" ? robot.ground : [];
  const rings = sensors.length ? sensors.map(({ x, y }) => ring(AROUND).translate(x, y, 0)) : [ring(reach + BEYOND)];
  const mesh = new Mesh(mergeGeometries(rings), LOOK.clone());
  mesh.position.z = HEIGHT;
  mesh.renderOrder = ORDER;
  return mesh;
}

/** Seen also through the robot. */
const LOOK = new MeshBasicMaterial({
  color: MARKS.beam,
  transparent: true,
  depthTest: false,
  depthWrite: false,
  toneMapped: false,
});

function ring(radius: number): BufferGeometry {
  return new RingGeometry(radius - WIDTH, radius, 40);
}
