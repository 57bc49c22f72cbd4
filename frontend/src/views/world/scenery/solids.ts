/** Coloured shapes, many of them in one mesh: each mesh costs a draw call. */

import {
  type BufferGeometry,
  Color,
  CylinderGeometry,
  ExtrudeGeometry,
  Float32BufferAttribute,
  LatheGeometry,
  Mesh,
  MeshLambertMaterial,
  type Shape,
  Vector2,
} from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

import type { XY } from "./description";

/** One shared material for all coloured meshes; none may change it. */
export const PAINT = new MeshLambertMaterial({ vertexColors: true });

/** Shapes that are drawn as one mesh. */
export class Parts {
  private readonly geometries: BufferGeometry[] = [];

  /** Add a shape centred at (x, y, z). */
  add(shape: BufferGeometry, colour: string, x = 0, y = 0, z = 0): this {
    this.geometries.push(painted(shape, colour).translate(x, y, z));
    return this;
  }

  mesh(): Mesh {
    return new Mesh(this.geometries.length ? mergeGeometries(this.geometries) : undefined, PAINT);
  }
}

function painted(shape: BufferGeometry, colour: string): BufferGeometry {
  const geometry = shape.index ? shape.toNonIndexed() : shape;
  geometry.deleteAttribute("uv");
  geometry.clearGroups();
  const { r, g, b } = new Color(colour);
  const corners = geometry.getAttribute("position").count;
  const colours = Array.from({ length: corners }, () => [r, g, b]).flat();
  return geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
}

/** A box with soft edges: long ahead, wide to the left, tall upwards. */
export function roundedBox(length: number, width: number, height: number, edge = 6): BufferGeometry {
  const radius = Math.min(edge, length / 2, width / 2, height / 2);
  return new RoundedBoxGeometry(length, width, height, 2, radius);
}

/** A standing cylinder. */
export function cylinder(radius: number, height: number, sides = 32): BufferGeometry {
  return new CylinderGeometry(radius, radius, height, sides).rotateX(Math.PI / 2);
}

/** A cylinder lying across, like a wheel. */
export function wheelDisc(radius: number, width: number, sides = 28): BufferGeometry {
  return new CylinderGeometry(radius, radius, width, sides);
}

/** The solid of revolution of (radius, height) points around the vertical axis. */
export function turned(profile: readonly XY[], sides = 40): BufferGeometry {
  return new LatheGeometry(
    profile.map(([r, z]) => new Vector2(r, z)),
    sides,
  ).rotateX(Math.PI / 2);
}

/** A plate with an outline of (ahead, left) points, its lower side at height 0, with soft edges. */
export function plate(outline: Shape, height: number, edge = 4): BufferGeometry {
  return new ExtrudeGeometry(outline, {
    depth: height - 2 * edge,
    bevelSize: edge,
    bevelThickness: edge,
    bevelOffset: -edge,
    bevelSegments: 3,
    curveSegments: 20,
  }).translate(0, 0, edge);
}
