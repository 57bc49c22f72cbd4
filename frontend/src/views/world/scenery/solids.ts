/** Coloured shapes, many of them in one mesh: each mesh costs a draw call. */

import {
  BoxGeometry,
  BufferGeometry,
  Color,
  CylinderGeometry,
  ExtrudeGeometry,
  Float32BufferAttribute,
  LatheGeometry,
  type Material,
  Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  type Shape,
  SphereGeometry,
  Vector2,
  Vector3,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

import type { XY } from "./description";
import { type Pose, radians } from "./geometry";

/** One shared material for all matt meshes; none may change it. */
export const PAINT = new MeshLambertMaterial({ vertexColors: true });
/** The coat of robots, which reflects the light. */
export const COAT = new MeshStandardMaterial({ vertexColors: true, roughness: 0.34 });

/** Shapes that are drawn as one mesh. */
export class Parts {
  private readonly geometries: BufferGeometry[] = [];

  /** Add a shape centred at (x, y, z). */
  add(shape: BufferGeometry, colour: string, x = 0, y = 0, z = 0): this {
    this.geometries.push(painted(shape, colour).translate(x, y, z));
    return this;
  }

  /** Add all shapes of another, turned and moved. */
  put(parts: Parts, { x, y, heading }: Pose, z = 0): this {
    for (const shape of parts.geometries) this.geometries.push(shape.rotateZ(-radians(heading)).translate(x, y, z));
    return this;
  }

  mesh(material: Material = PAINT): Mesh {
    const mesh = new Mesh(this.geometries.length ? mergeGeometries(this.geometries) : undefined, material);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    return mesh;
  }
}

/** A shape in one colour, for these materials. */
export function painted(shape: BufferGeometry, colour: string): BufferGeometry {
  const geometry = shape.index ? shape : shape.setIndex(numbered(shape.getAttribute("position").count));
  geometry.deleteAttribute("uv");
  geometry.clearGroups();
  const { r, g, b } = new Color(colour);
  const corners = geometry.getAttribute("position").count;
  const colours = new Float32Array(corners * 3);
  for (let i = 0; i < corners; i++) colours.set([r, g, b], 3 * i);
  return geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
}

function numbered(count: number): number[] {
  return Array.from({ length: count }, (_, i) => i);
}

type Point = [number, number, number];

/** Faces of four corners in one colour each; corners are clockwise seen from the front. */
export class Faces {
  private readonly positions: number[] = [];
  private readonly colours: number[] = [];

  quad(a: Point, b: Point, c: Point, d: Point, colour: string): void {
    const { r, g, b: blue } = new Color(colour);
    for (const point of [a, c, b, a, d, c]) {
      this.positions.push(...point);
      this.colours.push(r, g, blue);
    }
  }

  geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(this.positions, 3));
    geometry.setAttribute("color", new Float32BufferAttribute(this.colours, 3));
    geometry.computeVertexNormals();
    return geometry;
  }
}

/** A box with soft edges: long ahead, wide to the left, tall upwards. */
export function roundedBox(length: number, width: number, height: number, edge = 6): BufferGeometry {
  const radius = Math.min(edge, length / 2, width / 2, height / 2);
  const steps = stepsOf(radius);
  if (steps === 0) return new BoxGeometry(length, width, height);
  const inner = [length / 2 - radius, width / 2 - radius, height / 2 - radius] as const;
  const sides = 2 * steps + 1;
  const box = new BoxGeometry(2, 2, 2, sides, sides, sides);
  const [places, normals] = [box.getAttribute("position"), box.getAttribute("normal")];
  const normal = new Vector3();
  for (let i = 0; i < places.count; i++) {
    normal.fromBufferAttribute(places, i);
    const [x, y, z] = [Math.sign(normal.x), Math.sign(normal.y), Math.sign(normal.z)];
    normal.set(bent(normal.x, steps), bent(normal.y, steps), bent(normal.z, steps)).normalize();
    normals.setXYZ(i, normal.x, normal.y, normal.z);
    places.setXYZ(
      i,
      x * inner[0] + radius * normal.x,
      y * inner[1] + radius * normal.y,
      z * inner[2] + radius * normal.z,
    );
  }
  return box;
}

/** Faces between the flat side of a box and the middle of its edge: software draws each triangle slowly. */
function stepsOf(edge: number): number {
  if (edge < SHARP) return 0;
  return edge < ROUND ? 1 : 2;
}

/** An edge with a smaller radius is drawn sharp, and one with a larger radius is rounder, mm. */
const SHARP = 2.5;
const ROUND = 10;
/** The edge of a drum with a smaller radius is one slanting face, mm. */
const SMALL = 4;

/** From a place on the side of a cube, -1 to 1, to the direction of the edge there: the middle is flat. */
function bent(place: number, steps: number): number {
  const flat = 1 / (2 * steps + 1);
  return Math.sign(place) * Math.tan((Math.max(0, Math.abs(place) - flat) / (1 - flat)) * (Math.PI / 4));
}

/** A standing cylinder with soft edges, centred. */
export function drum(radius: number, height: number, edge = 6): BufferGeometry {
  const soft = Math.min(edge, radius / 2, height / 2);
  const half = height / 2;
  const steps = soft < SMALL ? 1 : 2;
  const quarter = (middle: number, from: number): XY[] =>
    Array.from({ length: steps + 1 }, (_, i) => {
      const angle = from + (i / steps) * (Math.PI / 2);
      return [radius - soft + soft * Math.cos(angle), middle + soft * Math.sin(angle)];
    });
  return turned([[0, -half], ...quarter(soft - half, -Math.PI / 2), ...quarter(half - soft, 0), [0, half]]);
}

/** How many flat sides look round: the middle of each is half a millimetre closer to the axis than a circle. */
function sidesOf(radius: number): number {
  return Math.max(8, 2 * Math.ceil(1.6 * Math.sqrt(radius)));
}

export function ball(radius: number): BufferGeometry {
  const sides = Math.max(8, 2 * Math.round(0.8 * Math.sqrt(radius)));
  return new SphereGeometry(radius, sides, Math.round(sides * 0.7)).rotateX(Math.PI / 2);
}

/** A standing cone, cut off at the top, centred. */
export function cone(bottom: number, top: number, height: number, sides = sidesOf(bottom)): BufferGeometry {
  return new CylinderGeometry(top, bottom, height, sides).rotateX(Math.PI / 2);
}

/** A standing cylinder. */
export function cylinder(radius: number, height: number, sides = sidesOf(radius)): BufferGeometry {
  return new CylinderGeometry(radius, radius, height, sides).rotateX(Math.PI / 2);
}

/** The solid of revolution of (radius, height) points around the vertical axis. */
export function turned(profile: readonly XY[]): BufferGeometry {
  const points = profile.map(([r, z]) => new Vector2(r, z));
  return new LatheGeometry(points, sidesOf(Math.max(...profile.map(([r]) => r)))).rotateX(Math.PI / 2);
}

/** A plate with an outline of (ahead, left) points, its lower side at height 0, with soft edges. */
export function plate(outline: Shape, height: number, edge = 4): BufferGeometry {
  return new ExtrudeGeometry(outline, {
    depth: height - 2 * edge,
    bevelSize: edge,
    bevelThickness: edge,
    bevelOffset: -edge,
    bevelSegments: 1 + stepsOf(edge),
    curveSegments: 12,
  }).translate(0, 0, edge);
}
