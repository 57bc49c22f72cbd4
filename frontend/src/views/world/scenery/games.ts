/** The things of games: what is collected, zones, gates, doors, switches, and what moves by itself. */

import {
  CircleGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  OctahedronGeometry,
  RingGeometry,
} from "three";

import type { Collectable, Door, Mover, RaceGate } from "../../../protocol/world";
import { friendly } from "./colours";
import type { CollectableKind, WorldValues, XY } from "./description";
import { COLLECTABLE_COLOURS as COLOURS, PLATE } from "./game-colours";
import { radians } from "./geometry";
import { circle, rectangle, shadows } from "./shadows";
import { ball, drum, Parts, roundedBox } from "./solids";
import { SHINE, star } from "./star";

/** Degrees a second that collectables turn. */
const TURNING = 90;
/** How high above the floor their middle is, in radii. */
const FLOATING = 1.5;
const SOFT = 8;
const POST = 10;
const POST_HEIGHT = 160;

/** What moves or changes in a game at one moment. */
export interface GameMoment {
  /** Seconds of the world. */
  readonly time: number;
  /** Where collectables are; null where one has been collected. */
  readonly things: readonly (XY | null)[];
  readonly doors: readonly boolean[];
}

/** Parts of a thing with a radius of 1 mm: its solids, with their colours. */
const SHAPES: Readonly<Record<Exclude<CollectableKind, "star">, (r: number) => Parts>> = {
  coin: (r) => new Parts().add(drum(r, r * 0.25, r * 0.1).rotateX(Math.PI / 2), COLOURS.coin),
  gem: (r) => new Parts().add(new OctahedronGeometry(r), COLOURS.gem),
  heart: (r) =>
    new Parts()
      .add(ball(r * 0.55), COLOURS.heart, -r * 0.4, 0, r * 0.25)
      .add(ball(r * 0.55), COLOURS.heart, r * 0.4, 0, r * 0.25)
      .add(new OctahedronGeometry(r * 0.85), COLOURS.heart, 0, 0, -r * 0.15),
  cherry: (r) =>
    new Parts().add(ball(r * 0.9), COLOURS.cherry).add(roundedBox(r * 0.15, r * 0.15, r * 0.5), "#5b4636", 0, 0, r),
  battery: (r) =>
    new Parts()
      .add(drum(r * 0.55, r * 1.6, r * 0.1), COLOURS.battery)
      .add(drum(r * 0.25, r * 0.3, r * 0.05), "#c9ced8", 0, 0, r * 0.95),
  key: (r) =>
    new Parts()
      .add(drum(r * 0.5, r * 0.25, r * 0.08).rotateX(Math.PI / 2), COLOURS.key, 0, 0, r * 0.5)
      .add(roundedBox(r * 0.22, r * 0.22, r * 1.3), COLOURS.key, 0, 0, -r * 0.4)
      .add(roundedBox(r * 0.5, r * 0.2, r * 0.2), COLOURS.key, r * 0.25, 0, -r * 0.8),
  flag: (r) =>
    new Parts()
      .add(roundedBox(r * 0.14, r * 0.14, r * 2), "#e8ecf5")
      .add(roundedBox(r * 1.1, r * 0.1, r * 0.7), COLOURS.flag, r * 0.6, 0, r * 0.6),
  bug: (r) =>
    new Parts()
      .add(ball(r * 0.9), COLOURS.bug, 0, 0, -r * 0.3)
      .add(ball(r * 0.45), "#26211f", r * 0.8, 0, -r * 0.4)
      .add(ball(r * 0.22), "#26211f", 0, r * 0.5, r * 0.3)
      .add(ball(r * 0.22), "#26211f", -r * 0.2, -r * 0.5, r * 0.3),
  ghost: (r) =>
    new Parts()
      .add(ball(r * 0.75), COLOURS.ghost, 0, 0, r * 0.3)
      .add(drum(r * 0.75, r * 1.1, r * 0.1), COLOURS.ghost, 0, 0, -r * 0.3)
      .add(ball(r * 0.16), "#1d2433", r * 0.65, r * 0.28, r * 0.4)
      .add(ball(r * 0.16), "#1d2433", r * 0.65, -r * 0.28, r * 0.4),
};

export class GameThings {
  readonly object = new Group();
  private readonly things: readonly Object3D[];
  private readonly turning: readonly Object3D[];
  private readonly doors: readonly Object3D[];

  constructor(world: WorldValues) {
    const things = world.collectable.map(collectable);
    this.things = things.map(({ whole }) => whole);
    this.turning = things.map(({ solid }) => solid);
    this.doors = world.door.map(door);
    const painted = [
      ...world.zone.map(({ x, y, radius, colour }) => disc(x, y, radius, friendly(colour))),
      ...world.switch.map(({ x, y, radius }) => disc(x, y, radius, PLATE)),
    ];
    for (const part of [...this.things, ...this.doors, ...painted]) this.object.add(part);
    if (world.gate.length) this.object.add(gates(world.gate));
  }

  show({ time, things, doors }: GameMoment): void {
    this.things.forEach((thing, i) => {
      const place = things[i];
      thing.visible = place !== null;
      if (place) thing.position.set(place[0], place[1], 0);
    });
    for (const solid of this.turning) solid.rotation.z = radians(TURNING * time);
    this.doors.forEach((one, i) => (one.visible = !doors[i]));
  }
}

/** What moves by itself, as tall as cameras see it. */
export function mover({ x, y, radius, height, colour }: Mover): Object3D {
  const group = new Group();
  const parts = new Parts().add(drum(radius, height, SOFT), friendly(colour), 0, 0, height / 2);
  for (const side of [-1, 1])
    parts.add(ball(radius * 0.2), "#ffffff", radius * 0.8, side * radius * 0.35, height * 0.8);
  group.add(parts.mesh(), shadows([circle(0, 0, radius)]));
  group.position.set(x, y, 0);
  return group;
}

function collectable({ kind, x, y, radius }: Collectable): { whole: Object3D; solid: Object3D } {
  const whole = new Group();
  const solid = kind === "star" ? star(radius) : SHAPES[kind](radius).mesh(SHINE_OF[kind]);
  solid.position.z = FLOATING * radius;
  whole.add(solid, shadows([circle(0, 0, radius * 0.7)]));
  whole.position.set(x, y, 0);
  return { whole, solid };
}

/** What gleams. */
const SHINE_OF: Partial<Record<CollectableKind, typeof SHINE>> = { coin: SHINE, key: SHINE };

function door({ x, y, heading, length, width, height, colour }: Door): Object3D {
  const group = new Group();
  const shape = roundedBox(length, width, height, SOFT);
  group.add(new Parts().add(shape, friendly(colour), 0, 0, height / 2).mesh());
  group.add(shadows([rectangle({ x: 0, y: 0, heading: 0 }, length, width)]));
  group.position.set(x, y, 0);
  group.rotation.z = -radians(heading);
  return group;
}

/** Two posts for each gate, with a bar above them. */
function gates(all: readonly RaceGate[]): Mesh {
  const parts = new Parts();
  for (const { x, y, heading, width } of all) {
    const gate = new Parts();
    for (const side of [-1, 1]) gate.add(drum(POST, POST_HEIGHT, 4), "#ffffff", 0, (side * width) / 2, POST_HEIGHT / 2);
    gate.add(roundedBox(POST, width, 30, 5), "#2f6fed", 0, 0, POST_HEIGHT);
    parts.put(gate, { x, y, heading });
  }
  return parts.mesh();
}

/** A round area on the floor with a rim. */
function disc(x: number, y: number, radius: number, color: string): Object3D {
  const group = new Group();
  const paint = (opacity: number) =>
    new MeshBasicMaterial({ color, opacity, transparent: true, depthWrite: false, side: DoubleSide });
  group.add(new Mesh(new CircleGeometry(radius, 40), paint(0.2)));
  group.add(new Mesh(new RingGeometry(radius - 6, radius, 40), paint(0.8)));
  group.position.set(x, y, 1.5);
  for (const part of group.children) part.renderOrder = 3;
  return group;
}
