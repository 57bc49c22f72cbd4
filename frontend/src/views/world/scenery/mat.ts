/** The floor: a chequered mat with a grid of 100 mm, or the colour or the picture of a world. */

import {
  type BufferGeometry,
  ExtrudeGeometry,
  Group,
  Mesh,
  MeshLambertMaterial,
  NoColorSpace,
  type Object3D,
  PlaneGeometry,
  type ShaderMaterial,
  Shape,
  ShapeGeometry,
} from "three";
import { friendly } from "./colours";
import type { FloorValues, XY } from "./description";
import { CELL, coloursOf, RIM } from "./floor-colours";
import { picturePaint, squaresPaint } from "./floor-paint";
import type { Palette } from "./palette";
import type { Pictures } from "./pictures";
import { PAINT, painted } from "./solids";

/** The rounding of the mat's corners, and how thick it is. */
const CORNER = 60;
const THICKNESS = 14;
/** A floor without a wall around it is a table. */
const TABLE = 60;

/** The order of drawing from front to back: what is hidden then costs little. */
export const BEHIND = { floor: 0.1, slab: 0.2, ground: 0.3, sky: 0.4 } as const;

/** How far below the floor the ground is, mm. */
export function depthBelow({ border }: FloorValues): number {
  return border > 0 ? THICKNESS : TABLE;
}

/** @param name of the world: its picture is at `worlds/NAME/floor.png`. */
export function mat(name: string, floor: FloorValues, palette: Palette, pictures: Pictures): Object3D {
  const group = new Group().add(surface(name, floor, palette, pictures), slab(floor, palette));
  if (floor.border === 0) group.add(rim(floor, palette));
  return group;
}

function surface(name: string, floor: FloorValues, palette: Palette, pictures: Pictures): Mesh {
  const geometry = floor.border > 0 ? new PlaneGeometry(...floor.size) : new ShapeGeometry(outline(floor.size, 0), 8);
  align(geometry);
  const mesh = new Mesh<BufferGeometry, ShaderMaterial>(
    geometry,
    squaresPaint(coloursOf(floor, palette), palette.shade),
  );
  mesh.receiveShadow = true;
  mesh.renderOrder = BEHIND.floor;
  if (floor.picture) {
    pictures.load(`worlds/${encodeURIComponent(name)}/floor.png`, NoColorSpace, (picture) => {
      mesh.material.dispose();
      mesh.material = picturePaint(picture, palette.shade);
      stretch(geometry, floor.size);
    });
  }
  return mesh;
}

/** Lay the squares so that a bold line goes through the middle of the floor. */
function align(geometry: PlaneGeometry | ShapeGeometry): void {
  const [positions, uvs] = [geometry.getAttribute("position"), geometry.getAttribute("uv")];
  for (let i = 0; i < uvs.count; i++) uvs.setXY(i, positions.getX(i) / CELL, positions.getY(i) / CELL);
}

function stretch(geometry: PlaneGeometry | ShapeGeometry, [width, depth]: XY): void {
  const [positions, uvs] = [geometry.getAttribute("position"), geometry.getAttribute("uv")];
  for (let i = 0; i < uvs.count; i++) uvs.setXY(i, positions.getX(i) / width + 0.5, positions.getY(i) / depth + 0.5);
  uvs.needsUpdate = true;
}

/** The outline of the mat, larger by a margin. */
function outline([width, depth]: XY, margin: number, into = new Shape()): Shape {
  const [x, y] = [width / 2 + margin, depth / 2 + margin];
  const r = Math.min(CORNER, width / 4, depth / 4) + margin;
  into
    .moveTo(r - x, -y)
    .lineTo(x - r, -y)
    .absarc(x - r, r - y, r, -Math.PI / 2, 0, false);
  into.lineTo(x, y - r).absarc(x - r, y - r, r, 0, Math.PI / 2, false);
  into.lineTo(r - x, y).absarc(r - x, y - r, r, Math.PI / 2, Math.PI, false);
  into.lineTo(-x, r - y).absarc(r - x, r - y, r, Math.PI, 1.5 * Math.PI, false);
  return into;
}

/** The side of the mat or table under the floor. */
function slab(floor: FloorValues, { rim: colour, mat: [wood] }: Palette): Mesh {
  const depth = depthBelow(floor);
  const table = floor.border === 0;
  const bevel = table ? 6 : 4;
  const shape = new ExtrudeGeometry(outline(floor.size, table ? 0 : RIM), {
    depth: depth - 2 * bevel - 1,
    bevelSize: bevel,
    bevelThickness: bevel,
    bevelOffset: -bevel,
    bevelSegments: 3,
    curveSegments: 10,
  }).translate(0, 0, bevel - depth);
  const own = floor.colour === "white" ? wood : friendly(floor.colour);
  // Only the sides: the floor hides the top.
  const [, sides] = shape.groups;
  const geometry = painted(shape, table ? own : colour);
  if (sides) geometry.setDrawRange(sides.start, sides.count);
  const mesh = new Mesh(geometry, PAINT);
  mesh.castShadow = table;
  mesh.renderOrder = BEHIND.slab;
  return mesh;
}

/** A line along the edge of a table. */
function rim({ size }: FloorValues, { rim: colour }: Palette): Mesh {
  const shape = outline(size, 0);
  shape.holes.push(outline(size, -14));
  const material = new MeshLambertMaterial({ color: colour, polygonOffset: true, polygonOffsetFactor: -1 });
  const mesh = new Mesh(new ShapeGeometry(shape, 8), material);
  mesh.position.z = 0.3;
  return mesh;
}
