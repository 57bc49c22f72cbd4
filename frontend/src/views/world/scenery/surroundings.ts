/** What is around the floor: the sky, the ground and low hills, which fade into each other. */

import {
  BackSide,
  BufferGeometry,
  CircleGeometry,
  Color,
  Float32BufferAttribute,
  Fog,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  Points,
  PointsMaterial,
  SphereGeometry,
} from "three";

import type { XY } from "./description";
import { groundPaint } from "./ground-paint";
import { BEHIND } from "./mat";
import type { Palette } from "./palette";
import { Parts } from "./solids";

/** The camera sees as far as this, mm. */
export const FARTHEST = 40_000;
const DOME = FARTHEST * 0.9;
/** Where the ground begins to fade, and where it has the colour of the horizon, in sizes of the floor. */
const FADE = [1.1, 4.5] as const;
/** The smallest floor for the fading, mm. */
const SMALLEST = 1500;
/** Direction in degrees, distance and width and height, in sizes of the floor. */
const HILLS: readonly (readonly [number, number, number, number])[] = [
  [100, 2.6, 1.7, 0.4],
  [62, 3, 2, 0.5],
  [140, 3.1, 2.1, 0.45],
  [20, 2.8, 1.7, 0.36],
  [180, 2.7, 1.6, 0.36],
  [245, 2.9, 1.9, 0.4],
  [300, 3.1, 1.8, 0.4],
];

const STARS = 160;

export interface Surroundings {
  readonly object: Object3D;
  readonly fog: Fog;
}

/** @param depth of the ground below the floor, mm. */
export function surroundings(size: XY, depth: number, palette: Palette): Surroundings {
  const reach = Math.max(SMALLEST, ...size);
  const fog = new Fog(palette.sky[2], FADE[0] * reach, FADE[1] * reach);
  const object = new Group().add(
    sky(palette),
    ...(palette.hasStars ? [stars()] : []),
    ground(depth, palette, fog),
    hills(reach, depth, palette),
  );
  return { object, fog };
}

function sky({ sky: [zenith, middle, horizon] }: Palette): Mesh {
  const geometry = new SphereGeometry(DOME, 12, 10, 0, 2 * Math.PI, 0, 0.55 * Math.PI).rotateX(Math.PI / 2);
  const heights = geometry.getAttribute("position");
  const colours: number[] = [];
  const [top, half, bottom] = [new Color(zenith), new Color(middle), new Color(horizon)];
  for (let i = 0; i < heights.count; i++) {
    const up = Math.max(0, heights.getZ(i) / DOME);
    const { r, g, b } = up < 0.3 ? bottom.clone().lerp(half, up / 0.3) : half.clone().lerp(top, (up - 0.3) / 0.7);
    colours.push(r, g, b);
  }
  geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
  const material = new MeshBasicMaterial({
    vertexColors: true,
    side: BackSide,
    depthWrite: false,
    fog: false,
    toneMapped: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = BEHIND.sky;
  return mesh;
}

/** Stars of the night sky, scattered evenly. */
function stars(): Points {
  const places = Array.from({ length: STARS }, (_, i) => {
    const up = 0.06 + ((0.9 * (i * 0.618034)) % 0.9);
    const [level, around] = [Math.sqrt(1 - up * up), i * 2.399963];
    return [level * Math.cos(around), level * Math.sin(around), up].map((one) => one * DOME * 0.98);
  });
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(places.flat(), 3));
  const material = new PointsMaterial({ color: "#dfe6ff", size: 2.2, sizeAttenuation: false, fog: false });
  material.toneMapped = false;
  return new Points(geometry, material);
}

function ground(depth: number, { ground: colour, sky }: Palette, fog: Fog): Mesh {
  const mesh = new Mesh(new CircleGeometry(DOME, 32), groundPaint(colour, sky[2], fog));
  mesh.position.z = -depth;
  mesh.renderOrder = BEHIND.ground;
  return mesh;
}

function hills(reach: number, depth: number, { hills: colours }: Palette): Mesh {
  const parts = new Parts();
  HILLS.forEach(([direction, distance, width, height], i) => {
    const angle = (direction * Math.PI) / 180;
    const shape = new SphereGeometry(1, 16, 5, 0, 2 * Math.PI, 0, 0.5 * Math.PI)
      .rotateX(Math.PI / 2)
      .scale(width, width, height)
      .scale(reach, reach, reach);
    const away = distance + width * 0.6;
    const [x, y] = [Math.cos(angle) * away * reach, Math.sin(angle) * away * reach];
    parts.add(shape, colours[i % colours.length] as string, x, y, -depth);
  });
  const mesh = parts.mesh();
  mesh.material = new MeshLambertMaterial({ vertexColors: true });
  mesh.castShadow = mesh.receiveShadow = false;
  mesh.renderOrder = BEHIND.ground;
  return mesh;
}
