/** The floor, the lines painted on it, and the wall at its edge. */

import { Color, Group, Mesh, MeshBasicMaterial, type Object3D } from "three";
import { friendly } from "./colours";
import type { FloorValues, WorldValues, XY } from "./description";
import { legible, RIM } from "./floor-colours";
import { mat } from "./mat";
import type { Palette } from "./palette";
import type { Pictures } from "./pictures";
import { ribbons } from "./ribbon";
import { Faces } from "./solids";

/** The light on the wall's sides: north, east, south and west of the floor. */
const LIGHT = [0.97, 1, 0.93, 0.9] as const;
const LINE_HEIGHT = 0.4;
/** The soft edge of the wall, mm. */
const SOFT = 8;
const SOFT_STEPS = 4;

/** The painted lines are flat: they need no light, and the floor must not hide them. */
export const LINE_PAINT = new MeshBasicMaterial({
  vertexColors: true,
  toneMapped: false,
  // Drawn with the translucent marks, in their order: a goal's halo goes below its line.
  transparent: true,
  depthWrite: false,
  polygonOffset: true,
  polygonOffsetFactor: -1,
});

/**
 * The floor with everything flat on it.
 *
 * @param name of the world.
 * @param lines the corners of each line's middle.
 */
export function floor(
  name: string,
  world: WorldValues,
  lines: readonly XY[][],
  palette: Palette,
  pictures: Pictures,
): Object3D {
  const group = new Group().add(
    mat(name, world.floor, legible(palette, world.line), pictures),
    paintedLines(world, lines),
  );
  if (world.floor.border > 0) group.add(border(world.floor, palette));
  return group;
}

/** @param lines the corners of each line's middle. */
export function paintedLines(world: WorldValues, lines: readonly XY[][]): Mesh {
  const all = world.line.map((line, i) => ({
    points: lines[i] ?? [],
    width: line.width,
    colour: friendly(line.colour),
  }));
  const mesh = new Mesh(ribbons(all, LINE_HEIGHT), LINE_PAINT);
  mesh.renderOrder = 1;
  return mesh;
}

/** The border's inner sides and top: the outer sides would hide the objects behind them. */
function border({ size, border: height }: FloorValues, { border: side, rim }: Palette): Mesh {
  const faces = new Faces();
  const profile = profileOf(height);
  const corners = [0, 1, 2, 3] as const;
  for (const corner of corners) {
    profile.slice(1).forEach(([out, z], i) => {
      const [before, below] = profile[i] as XY;
      const [a, b] = [at(size, corner, before), at(size, (corner + 1) % 4, before)];
      const [c, d] = [at(size, (corner + 1) % 4, out), at(size, corner, out)];
      const shade = new Color(i === 0 ? side : rim).multiplyScalar(LIGHT[(corner + 1) % 4] as number);
      faces.quad([...a, below], [...d, z], [...c, z], [...b, below], shade.getStyle());
    });
  }
  return new Mesh(faces.geometry(), new MeshBasicMaterial({ vertexColors: true, toneMapped: false }));
}

/** From the floor up its inner side and over its soft edge: (outwards, up). */
function profileOf(height: number): XY[] {
  const soft = Math.min(SOFT, height);
  const edge = Array.from({ length: SOFT_STEPS + 1 }, (_, i): XY => {
    const angle = (i / SOFT_STEPS) * (Math.PI / 2);
    return [soft - soft * Math.cos(angle), height - soft + soft * Math.sin(angle)];
  });
  return [[0, 0], ...edge, [RIM, height]];
}

/** A corner of the floor, farther out; clockwise from the north-east. */
function at([width, depth]: XY, corner: number, out: number): XY {
  const [x, y] = [width / 2 + out, depth / 2 + out];
  return [corner < 2 ? x : -x, corner === 0 || corner === 3 ? y : -y];
}
