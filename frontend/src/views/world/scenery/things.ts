/** The objects in a world: walls, boxes, cylinders, boards, lamps. */

import {
  Color,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  PlaneGeometry,
  RingGeometry,
} from "three";

import { friendly } from "./colours";
import type { BoardValues, BoxValues, CylinderValues, LampValues, WallValues, WorldValues, XY } from "./description";
import { forward, headingOf, type Pose, radians } from "./geometry";
import { type Palette, wallColour } from "./palette";
import type { Pictures } from "./pictures";
import { circle, rectangle, shadows } from "./shadows";
import { ball, drum, Parts, roundedBox, turned } from "./solids";

const BOARD = "#ffffff";
const BOARD_FOOT = "#8257e6";
const BOARD_THICKNESS = 6;
/** The soft edges of boxes, cylinders and walls, mm. */
const SOFT = 9;
const SOFT_WALL = 7;
/** The light of a lamp on the floor: its colour, its opacity below the lamp, and the steps in which it fades. */
const LIGHT = "#ffd34d";
const GLOW = 0.85;
const GLOW_RINGS = 8;

/** The fixed objects, and the movable ones in the order of telemetry. */
export interface Things {
  readonly fixed: Object3D;
  readonly pushed: readonly Object3D[];
}

export function things(world: WorldValues, palette: Palette, pictures: Pictures): Things {
  const fixed = new Group();
  fixed.add(standing(world, palette), shadows(outlines(world)));
  for (const tag of world.tag) fixed.add(poster(tag, `textures/tag/${tag.id}.png`, pictures));
  for (const face of world.face) fixed.add(poster(face, `textures/face/${face.emotion}.png`, pictures));
  const boxes = world.box.filter(isPushed).map(loose(solidBox));
  const cylinders = world.cylinder.filter(isPushed).map(loose(solidCylinder));
  return { fixed, pushed: [...boxes, ...cylinders] };
}

function isPushed(thing: { mass: number | null }): boolean {
  return thing.mass !== null;
}

function isFixed(thing: { mass: number | null }): boolean {
  return thing.mass === null;
}

/** All fixed objects, in one mesh. */
function standing(world: WorldValues, palette: Palette): Mesh {
  const parts = new Parts();
  world.wall.forEach((wall, i) => addWall(parts, wall, wallColour(palette, wall, i)));
  for (const box of world.box.filter(isFixed)) addBox(parts, box);
  for (const thing of world.cylinder.filter(isFixed)) {
    parts.add(solidCylinder(thing), friendly(thing.colour), thing.x, thing.y, thing.height / 2);
  }
  for (const board of [...world.tag, ...world.face]) addBoard(parts, board);
  for (const lamp of world.light) addLamp(parts, lamp);
  return parts.mesh();
}

function outlines(world: WorldValues): XY[][] {
  const round = world.cylinder.filter(isFixed).map(({ x, y, radius }) => circle(x, y, radius));
  const boxes = world.box.filter(isFixed).map((box) => rectangle(box, box.length, box.width));
  const walls = world.wall.flatMap((wall) =>
    piecesOf(wall).map(({ pose, length }) => rectangle(pose, length, wall.thickness)),
  );
  return [...round, ...boxes, ...walls];
}

function solidBox(box: BoxValues) {
  return roundedBox(box.length, box.width, box.height, SOFT);
}

function solidCylinder({ radius, height }: CylinderValues) {
  return drum(radius, height, SOFT);
}

function addBox(parts: Parts, box: BoxValues): void {
  parts.add(solidBox(box).rotateZ(-radians(box.heading)), friendly(box.colour), box.x, box.y, box.height / 2);
}

function loose<T extends { height: number; colour: BoxValues["colour"]; x: number; y: number }>(
  shape: (thing: T) => ReturnType<typeof solidBox>,
): (thing: T) => Object3D {
  return (thing) => {
    const group = new Group();
    group.add(new Parts().add(shape(thing), friendly(thing.colour), 0, 0, thing.height / 2).mesh());
    group.add(shadows([footprint(thing)]));
    place(group, { x: thing.x, y: thing.y, heading: "heading" in thing ? Number(thing.heading) : 0 });
    return group;
  };
}

function footprint(thing: object): XY[] {
  if ("radius" in thing) return circle(0, 0, Number(thing.radius));
  const { length, width } = thing as BoxValues;
  return rectangle({ x: 0, y: 0, heading: 0 }, length, width);
}

/** Move an object on the floor. */
export function place(object: Object3D, { x, y, heading }: Pose): void {
  object.position.set(x, y, 0);
  object.rotation.z = -radians(heading);
}

function addWall(parts: Parts, wall: WallValues, colour: string): void {
  for (const { pose, length } of piecesOf(wall)) {
    const piece = roundedBox(length, wall.thickness, wall.height, SOFT_WALL).rotateZ(-radians(pose.heading));
    parts.add(piece, colour, pose.x, pose.y, wall.height / 2);
  }
}

/** The straight pieces of a wall; each end is extended by half of the thickness, which closes the corners. */
export function piecesOf({ points, thickness }: WallValues): { pose: Pose; length: number }[] {
  return points.slice(1).flatMap((end, i) => {
    const start = points[i] ?? end;
    const [dx, dy] = [end[0] - start[0], end[1] - start[1]];
    if (dx === 0 && dy === 0) return [];
    const pose = { x: start[0] + dx / 2, y: start[1] + dy / 2, heading: headingOf(dx, dy) };
    return [{ pose, length: Math.hypot(dx, dy) + thickness }];
  });
}

/** A board on a post with a foot; its picture is drawn just in front of it. */
function addBoard(parts: Parts, board: BoardValues): void {
  const turn = -radians(board.heading);
  const [x, y] = forward(board.heading);
  const behind = BOARD_THICKNESS / 2 + 1;
  const [middleX, middleY] = [board.x - behind * x, board.y - behind * y];
  const frame = board.size + 12;
  parts.add(roundedBox(BOARD_THICKNESS, frame, frame, 3).rotateZ(turn), BOARD, middleX, middleY, board.z);
  const bottom = board.z - frame / 2;
  if (bottom <= 0) return;
  const post = roundedBox(BOARD_THICKNESS, board.size / 5, bottom, 2).rotateZ(turn);
  parts.add(post, BOARD_FOOT, middleX, middleY, bottom / 2);
  const foot = roundedBox(30, board.size * 0.6, 8, 4).rotateZ(turn);
  parts.add(foot, BOARD_FOOT, middleX, middleY, 4);
}

function poster(board: BoardValues, address: string, pictures: Pictures): Mesh {
  const material = new MeshLambertMaterial({ color: "#f4f4f4" });
  pictures.on(material, address);
  // A plane is created flat on the floor with its picture's top to the north: raise it and turn it to face ahead.
  const shape = new PlaneGeometry(board.size, board.size).rotateX(Math.PI / 2).rotateZ(Math.PI / 2);
  const mesh = new Mesh(shape, material);
  place(mesh, board);
  mesh.position.z = board.z;
  return mesh;
}

/** A lamp that hangs above its position, thin enough to hide nothing. */
function addLamp(parts: Parts, { x, y, z }: LampValues): void {
  const shade: XY[] = [
    [0, 40],
    [10, 38],
    [44, 8],
    [44, 0],
    [38, 0],
    [0, 30],
  ];
  parts.add(turned(shade.toReversed()), "#4f6bed", x, y, z);
  parts.add(ball(20), "#fff1b0", x, y, z + 4);
}

/** The light of a lamp on the floor, which fades outwards. */
export function glow({ x, y, z, brightness }: LampValues): Mesh {
  const radius = Math.min(600, z * 0.9);
  const geometry = new RingGeometry(0, radius, 40, GLOW_RINGS);
  const places = geometry.getAttribute("position");
  const most = GLOW * Math.min(1, brightness / 600);
  const { r, g, b } = new Color(LIGHT);
  const colours = Array.from({ length: places.count }, (_, i) => {
    const far = Math.hypot(places.getX(i), places.getY(i)) / radius;
    return [r, g, b, most * (1 - far) ** 2];
  });
  geometry.setAttribute("color", new Float32BufferAttribute(colours.flat(), 4));
  const material = new MeshBasicMaterial({
    vertexColors: true,
    toneMapped: false,
    transparent: true,
    depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.position.set(x, y, 1);
  mesh.renderOrder = 2;
  return mesh;
}
