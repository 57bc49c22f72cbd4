/** Stars: what robots are sent for. */

import { ExtrudeGeometry, type Mesh, MeshStandardMaterial, Shape } from "three";

import { MARKS } from "./colours";
import { Parts } from "./solids";

const POINTS = 5;
const DEPTH = 0.28;
const SOFT = 0.14;

/** Stars shine at night, too. */
export const SHINE = new MeshStandardMaterial({
  vertexColors: true,
  roughness: 0.34,
  emissive: "#a86400",
  emissiveIntensity: 0.5,
});

/** A standing star whose front faces south, with the given radius, mm. */
export function star(radius: number): Mesh {
  const shape = new Shape();
  for (let i = 0; i < 2 * POINTS; i++) {
    const angle = Math.PI / 2 + (i * Math.PI) / POINTS;
    const reach = (i % 2 ? 0.5 : 1) * (1 - SOFT);
    const [x, y] = [reach * Math.cos(angle), reach * Math.sin(angle)];
    if (i) shape.lineTo(x, y);
    else shape.moveTo(x, y);
  }
  const solid = new ExtrudeGeometry(shape, {
    depth: DEPTH,
    bevelSize: SOFT,
    bevelThickness: SOFT,
    bevelSegments: 3,
    steps: 1,
  });
  solid
    .translate(0, 0, -DEPTH / 2)
    .scale(radius, radius, radius)
    .rotateX(Math.PI / 2);
  return new Parts().add(solid, MARKS.star).mesh(SHINE);
}
