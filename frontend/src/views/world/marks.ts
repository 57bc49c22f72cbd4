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
import type { GoalNow } from "../../protocol/messages";
import { MARKS } from "./scenery/colours";
import type { WorldValues, XY } from "./scenery/description";
import { from, type Pose } from "./scenery/geometry";
import { ribbons } from "./scenery/ribbon";
import { place } from "./scenery/things";

const HEIGHT = 1.2;
const SIGN_HEIGHT = 190;
const SIGN_PIXELS = 64;
const SIGNS = { open: "⚑", reached: "✓", failed: "✗" } as const;
type State = GoalNow["state"];

function flat(geometry: BufferGeometry, colour: string, opacity: number): Mesh<BufferGeometry, MeshBasicMaterial> {
  const material = new MeshBasicMaterial({
    color: colour,
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

/** An arrow in a ring: a robot's start and its heading. */
export function startMark(pose: Pose): Object3D {
  const arrow = new Shape();
  arrow.moveTo(48, 0).lineTo(-26, 30).lineTo(-12, 0).lineTo(-26, -30);
  const group = new Group();
  group.add(flat(new RingGeometry(62, 70, 40), MARKS.start, 0.7), flat(new ShapeGeometry(arrow), MARKS.start, 0.55));
  place(group, pose);
  return group;
}

/** A goal's mark, with the colour and sign of its state. */
export class GoalMark {
  readonly object = new Group();
  private state: State | null = null;
  private readonly sign = new Sprite(new SpriteMaterial({ depthTest: false }));

  constructor(
    private readonly shapes: readonly Mesh<BufferGeometry, MeshBasicMaterial>[],
    [x, y]: XY,
    private readonly signs: Signs,
  ) {
    this.object.add(...shapes, this.sign);
    this.sign.position.set(x, y, SIGN_HEIGHT);
    this.sign.scale.setScalar(85);
    this.sign.renderOrder = 9;
    this.show("open");
  }

  /** Show the goal's state; return whether it changed. */
  show(state: State): boolean {
    if (state === this.state) return false;
    this.state = state;
    for (const shape of this.shapes) shape.material.color.set(MARKS[state]);
    this.sign.material.map = this.signs.of(state);
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
  const reach = world.goal.reach.map(({ x, y, radius }) => new GoalMark(region(x, y, radius), [x, y], signs));
  const follow = world.goal.follow.map(({ line }) => {
    const index = world.line.findIndex(({ name }) => name === line);
    return followMark(lines[index] ?? [], (world.line[index]?.width ?? 40) + 50, signs);
  });
  const visit = world.goal.visit.map(({ id, distance }) => visitMark(world, id, distance, signs));
  return [...reach, ...follow, ...visit];
}

function region(x: number, y: number, radius: number): Mesh<BufferGeometry, MeshBasicMaterial>[] {
  const disc = flat(new CircleGeometry(radius, 48).translate(x, y, 0), MARKS.open, 0.2);
  const ring = flat(new RingGeometry(radius - 8, radius, 48).translate(x, y, 0), MARKS.open, 0.8);
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
