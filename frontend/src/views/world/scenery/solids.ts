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
  const inner = [length / 2 - radius, width / 2 - radius, height / 2 - radius] as const;
  const sides = 2 * EDGE_STEPS + 1;
  const box = new BoxGeometry(2, 2, 2, sides, sides, sides);
  const [places, normals] = [box.getAttribute("position"), box.getAttribute("normal")];
  const normal = new Vector3();
  for (let i = 0; i < places.count; i++) {
    normal.fromBufferAttribute(places, i);
    const [x, y, z] = [Math.sign(normal.x), Math.sign(normal.y), Math.sign(normal.z)];
    normal.set(bent(normal.x), bent(normal.y), bent(normal.z)).normalize();
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

/** Faces between the flat side of a box and the middle of its edge. */
const EDGE_STEPS = 2;

/** From a place on the side of a cube, -1 to 1, to the direction of the edge there: the middle is flat. */
function bent(place: number): number {
  const flat = 1 / (2 * EDGE_STEPS + 1);
  return Math.sign(place) * Math.tan((Math.max(0, Math.abs(place) - flat) / (1 - flat)) * (Math.PI / 4));
}

/** A standing cylinder with soft edges, centred. */
export function drum(radius: number, height: number, edge = 6, sides = 40): BufferGeometry {
  const soft = Math.min(edge, radius / 2, height / 2);
  const half = height / 2;
  const quarter = (middle: number, from: number): XY[] =>
    [0, 1, 2, 3].map((i) => {
      const angle = from + (i / 3) * (Math.PI / 2);
      return [radius - soft + soft * Math.cos(angle), middle + soft * Math.sin(angle)];
    });
  return turned([[0, -half], ...quarter(soft - half, -Math.PI / 2), ...quarter(half - soft, 0), [0, half]], sides);
}

export function ball(radius: number, detail = 20): BufferGeometry {
  return new SphereGeometry(radius, detail, Math.round(detail * 0.7)).rotateX(Math.PI / 2);
}

/** A standing cone, cut off at the top, centred. */
export function cone(bottom: number, top: number, height: number, sides = 24): BufferGeometry {
  return new CylinderGeometry(top, bottom, height, sides).rotateX(Math.PI / 2);
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
