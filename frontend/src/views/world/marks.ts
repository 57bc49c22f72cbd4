/** Marks on the floor: the start of the run, and the states of the goals. */

import {
  type BufferGeometry,
  CanvasTexture,
  CircleGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  RingGeometry,
  Shape,
  ShapeGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import type { GoalNow } from "../../protocol/messages";
import { MARKS } from "./scenery/colours";
import type { WorldValues, XY } from "./scenery/description";
import { between, from, type Pose } from "./scenery/geometry";
import { ribbons } from "./scenery/ribbon";
import { star } from "./scenery/star";
import { colourOfTeam } from "./scenery/teams";
import { place } from "./scenery/things";

const HEIGHT = 1.2;
/** The radius of a start, and the length of a dash with its gap, mm. */
const START = 88;
const DASH = 36;
const SIGN_HEIGHT = 190;
/** A star floats above the floor, or above the robot that starts there; it fits into its goal. */
const STAR = { part: 0.62, least: 20, most: 44, above: 14, high: 190, near: 160 } as const;
const SIGN_PIXELS = 64;
const SIGNS = { open: "⚑", reached: "✓", failed: "✗" } as const;
type State = GoalNow["state"];

function flat(geometry: BufferGeometry, colour: string, opacity: number): Mesh<BufferGeometry, MeshBasicMaterial> {
  const material = new MeshBasicMaterial({
    color: colour,
    toneMapped: false,
    transparent: true,
    opacity,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -3,
  });
  const mesh = new Mesh(geometry, material);
  mesh.position.z = HEIGHT;
  mesh.renderOrder = 3;
  return mesh;
}

/** A dashed ring: a robot's start, with a tip that shows its heading. */
export function startMark(pose: Pose): Object3D {
  const tip = new Shape();
  tip
    .moveTo(START + 34, 0)
    .lineTo(START + 10, 17)
    .lineTo(START + 10, -17);
  const group = new Group();
  const parts = [new CircleGeometry(START, 40), dashes(START, 9), new ShapeGeometry(tip)] as const;
  group.add(flat(parts[0], MARKS.start, 0.12), flat(parts[1], MARKS.start, 0.9), flat(parts[2], MARKS.start, 0.9));
  place(group, pose);
  return group;
}

/** A dashed ring with an outer radius and a width, mm. */
function dashes(radius: number, width: number): BufferGeometry {
  const count = Math.max(8, Math.round((2 * Math.PI * radius) / DASH));
  const angle = (2 * Math.PI) / count;
  const pieces = Array.from(
    { length: count },
    (_, i) => new RingGeometry(radius - width, radius, 4, 1, i * angle, angle * 0.62),
  );
  return mergeGeometries(pieces);
}

/** A goal's mark, with the colour and sign of its state. */
export class GoalMark {
  readonly object = new Group();
  private own: string | null = null;
  private state: State | null = null;
  private readonly sign = new Sprite(new SpriteMaterial({ depthTest: false }));

  /** @param stars are there until the goal is reached or missed. */
  constructor(
    private readonly shapes: readonly Mesh<BufferGeometry, MeshBasicMaterial>[],
    readonly place: XY,
    private readonly signs: Signs,
    private readonly stars: readonly Object3D[] = [],
  ) {
    this.object.add(...shapes, ...stars, this.sign);
    this.sign.position.set(...place, SIGN_HEIGHT);
    this.sign.scale.setScalar(58);
    this.sign.renderOrder = 9;
    this.show("open");
  }

  /** Have the colour of a team until it is reached or missed. */
  belongTo(colour: string): void {
    this.own = colour;
    const { state } = this;
    this.state = null;
    this.show(state ?? "open");
  }

  /** Turn its stars to a place. */
  face(x: number, y: number): void {
    for (const { position, rotation } of this.stars) {
      rotation.z = Math.atan2(y - position.y, x - position.x) + Math.PI / 2;
    }
  }

  /** Show the goal's state; return whether it changed. */
  show(state: State): boolean {
    if (state === this.state) return false;
    this.state = state;
    const colour = (state === "open" && this.own) || MARKS[state];
    for (const shape of this.shapes) shape.material.color.set(colour);
    for (const one of this.stars) one.visible = state === "open";
    this.sign.visible = state !== "open" || this.stars.length === 0;
    this.sign.material.map = this.signs.of(state);
    this.sign.material.needsUpdate = true;
    return true;
  }
}

/** The signs over goals, because colour alone is not accessible. */
export class Signs {
  private readonly drawn = new Map<State, CanvasTexture>();

  of(state: State): CanvasTexture {
    const texture = this.drawn.get(state) ?? drawSign(state);
    this.drawn.set(state, texture);
    return texture;
  }

  dispose(): void {
    for (const texture of this.drawn.values()) texture.dispose();
  }
}

function drawSign(state: State): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = SIGN_PIXELS;
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  const half = SIGN_PIXELS / 2;
  pen.fillStyle = MARKS[state];
  pen.arc(half, half, half - 2, 0, 2 * Math.PI);
  pen.fill();
  pen.fillStyle = "white";
  pen.font = `bold ${SIGN_PIXELS * 0.62}px sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(SIGNS[state], half, half + 3);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** The marks of a world's goals, in the order of telemetry. */
export function goalMarks(world: WorldValues, lines: readonly XY[][], signs: Signs): GoalMark[] {
  const places = (points: readonly XY[], radius: number): GoalMark => {
    const shapes = points.flatMap(([x, y]) => region(x, y, radius));
    const stars = points.map((point) => starAt(point, radius, world));
    return new GoalMark(shapes, points.at(-1) ?? [0, 0], signs, stars);
  };
  const reach = world.goal.reach.map(({ x, y, radius }) => places([[x, y]], radius));
  const follow = world.goal.follow.map(({ line }) => {
    const index = world.line.findIndex(({ name }) => name === line);
    return followMark(lines[index] ?? [], (world.line[index]?.width ?? 40) + 50, signs);
  });
  const visit = world.goal.visit.map(({ id, distance }) => visitMark(world, id, distance, signs));
  const tour = world.goal.tour.map(({ points, radius }) => places(points, radius));
  const stop = world.goal.stop.map(({ x, y, radius }) => places([[x, y]], radius));
  const show = world.goal.show.map(({ x, y, radius }) =>
    radius === null ? new GoalMark([], entrance(world), signs) : places([[x, y]], radius),
  );
  const avoid = world.goal.avoid.map(() => new GoalMark([], entrance(world), signs));
  const marks = [...reach, ...follow, ...visit, ...tour, ...stop, ...show, ...avoid];
  goalsWithMarks(world).forEach(({ team }, index) => {
    const colour = colourOfTeam(world, team);
    if (colour) marks[index]?.belongTo(colour);
  });
  return marks;
}

function goalsWithMarks({ goal }: WorldValues): readonly { readonly team: string | null }[] {
  return [goal.reach, goal.follow, goal.visit, goal.tour, goal.stop, goal.show, goal.avoid].flat();
}

function starAt([x, y]: XY, goal: number, { start }: WorldValues): Object3D {
  const radius = between(STAR.part * goal, STAR.least, STAR.most);
  const isStart = start.some((pose) => Math.hypot(pose.x - x, pose.y - y) < STAR.near);
  const one = star(radius);
  one.position.set(x, y, radius + (isStart ? STAR.high : STAR.above));
  return one;
}

/** The places of the goals that have one, the first goal's first. */
export function goalPlaces({ goal, tag, ...things }: WorldValues): readonly XY[] {
  const visited = goal.visit.flatMap(({ id }) => tag.filter((one) => one.id === id));
  const toured = goal.tour.flatMap(({ points }) => points.map(([x, y]) => ({ x, y })));
  const shown = goal.show.filter(({ radius }) => radius !== null);
  // A switch opens the way to what is behind its door.
  const played = [...things.collectable, ...things.switch, ...things.gate, ...things.zone];
  return [...goal.reach, ...visited, ...toured, ...goal.stop, ...shown, ...played].map(({ x, y }): XY => [x, y]);
}

/** mm: showing a line farther away would make the robot too small. */
const NEAR = 1300;

/** The middle of the farthest line that is near a place: what a world without goals is about. */
export function farthestLine({ line }: WorldValues, x: number, y: number): XY | null {
  const middles = line.map(({ points }): XY => {
    const [xs, ys] = [points.map(([at]) => at), points.map(([, at]) => at)];
    return [middle(xs), middle(ys)];
  });
  const away = ([atX, atY]: XY) => Math.hypot(atX - x, atY - y);
  const near = middles.filter((one) => away(one) < NEAR).sort((one, other) => away(other) - away(one));
  return near[0] ?? null;
}

function middle(values: readonly number[]): number {
  return (Math.min(...values) + Math.max(...values)) / 2;
}

/** The first start, for goals that have no place. */
function entrance(world: WorldValues): XY {
  const [first] = world.start;
  return first ? [first.x, first.y] : [0, 0];
}

function region(x: number, y: number, radius: number): Mesh<BufferGeometry, MeshBasicMaterial>[] {
  const disc = flat(new CircleGeometry(radius, 48).translate(x, y, 0), MARKS.open, 0.18);
  const ring = flat(dashes(radius, 10).translate(x, y, 0), MARKS.open, 0.95);
  return [disc, ring];
}

function followMark(points: readonly XY[], width: number, signs: Signs): GoalMark {
  // Without vertex colours, which would override the mark's colour.
  const geometry = ribbons([{ points, width, colour: "#fff" }], 0).deleteAttribute("color");
  const halo = flat(geometry, MARKS.open, 0.35);
  halo.position.z = 0.2;
  halo.renderOrder = 0.5;
  return new GoalMark([halo], points.at(-1) ?? [0, 0], signs);
}

function visitMark(world: WorldValues, id: number, distance: number, signs: Signs): GoalMark {
  const tag = world.tag.find((candidate) => candidate.id === id);
  if (!tag) return new GoalMark([], [0, 0], signs);
  // Half a disc in front of the tag: a robot must see its front.
  const reach = Math.min(distance, 1000);
  const half = flat(new CircleGeometry(reach, 32, -Math.PI / 2, Math.PI), MARKS.open, 0.13);
  place(half, tag);
  half.position.z = HEIGHT;
  return new GoalMark([half], from(tag, -20), signs);
}
