/** The ground: its colour or picture, the wall around it, and the lines painted on it. */

import {
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
} from "three";

import { css } from "./colours";
import type { FloorValues, WorldValues, XY } from "./description";
import type { Pictures } from "./pictures";
import { ribbons } from "./ribbon";
import { PAINT } from "./solids";

const BORDER_INSIDE = "#d7d4c8";
const BORDER_TOP = "#b9b4a2";
const BORDER_THICKNESS = 14;
const LINE_HEIGHT = 0.4;

/** The painted lines are flat: they need no light, and the floor must not hide them. */
export const LINE_PAINT = new MeshBasicMaterial({
  vertexColors: true,
  // Drawn with the translucent marks, in their order: a goal's halo goes below its line.
  transparent: true,
  depthWrite: false,
  polygonOffset: true,
  polygonOffsetFactor: -1,
});

/**
 * The floor with everything flat on it.
 *
 * @param name of the world: its picture is at `worlds/NAME/floor.png`.
 * @param lines the corners of each line's middle.
 */
export function floor(name: string, world: WorldValues, lines: readonly XY[][], pictures: Pictures): Object3D {
  const group = new Group();
  group.add(ground(name, world.floor, pictures), paintedLines(world, lines));
  if (world.floor.border > 0) group.add(border(world.floor));
  return group;
}

function ground(name: string, floor: FloorValues, pictures: Pictures): Mesh {
  // Without lighting: the largest surface is the cheapest to draw.
  const material = new MeshBasicMaterial({ color: css(floor.colour) });
  if (floor.picture) pictures.on(material, `worlds/${encodeURIComponent(name)}/floor.png`);
  return new Mesh(new PlaneGeometry(...floor.size), material);
}

function paintedLines(world: WorldValues, lines: readonly XY[][]): Mesh {
  const all = world.line.map((line, i) => ({
    points: lines[i] ?? [],
    width: line.width,
    colour: css(line.colour),
  }));
  const mesh = new Mesh(ribbons(all, LINE_HEIGHT), LINE_PAINT);
  mesh.renderOrder = 1;
  return mesh;
}

/** The border's inner sides and top: the outer sides would hide the objects behind them. */
function border({ size, border: height }: FloorValues): Mesh {
  const [x, y] = [size[0] / 2, size[1] / 2];
  const inner: XY[] = [
    [x, y],
    [x, -y],
    [-x, -y],
    [-x, y],
  ];
  const faces = new Faces();
  inner.forEach((start, i) => {
    const end = inner[(i + 1) % 4] ?? start;
    faces.quad([...start, 0], [...start, height], [...end, height], [...end, 0], BORDER_INSIDE);
    faces.quad([...start, height], [...away(start), height], [...away(end), height], [...end, height], BORDER_TOP);
  });
  return new Mesh(faces.geometry(), PAINT);
}

function away([x, y]: XY): XY {
  return [x + Math.sign(x) * BORDER_THICKNESS, y + Math.sign(y) * BORDER_THICKNESS];
}

type Point = [number, number, number];

/** Faces of four corners in one colour each; corners are clockwise seen from the front. */
class Faces {
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
