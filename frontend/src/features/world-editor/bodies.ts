/** The room that each object takes in the world, for pointing at it in 3D. */

import { Box3 } from "three";

import { listOf, type Ref, type Thing } from "../../views/world/plan/sorts";
import type {
  LineValues,
  PropKind,
  PropValues,
  WallValues,
  WorldValues,
  XY,
} from "../../views/world/scenery/description";
import { cornersOf, type Pose } from "../../views/world/scenery/geometry";
import { namedProps } from "../../views/world/scenery/props";
import { circle, rectangle } from "../../views/world/scenery/shadows";
import { piecesOf } from "../../views/world/scenery/things";
import { placeOf } from "./things";

/** Between two heights above an outline, mm. */
export interface Body {
  readonly outline: readonly XY[];
  readonly bottom: number;
  readonly top: number;
}

/** Boards and walls are thinner than a finger. */
const THINNEST = 40;
/** Of the robot at a start, and of what has no size of its own. */
const ROBOT = { radius: 90, height: 110 };
const SIGN = 50;
/** Of the posts of a gate. */
const GATE_HEIGHT = 160;
/** The radii of a thing to collect up to its top: it floats. */
const FLOATING = 2.5;
/** Of the shade of a lamp. */
const SHADE = { radius: 50, height: 70 };

/** The bodies of an object; none if it is only a chain, like a line. */
export function bodiesOf(world: WorldValues, { sort, index }: Ref): Body[] {
  const thing = listOf(world, sort)[index] ?? {};
  const pose = { x: Number(thing.x), y: Number(thing.y), heading: Number(thing.heading ?? 0) };
  switch (sort) {
    case "line":
    case "tour":
      return [];
    case "wall":
      return wallBodies(thing as unknown as WallValues);
    case "box":
    case "door":
      return [standing(rectangle(pose, Number(thing.length), Number(thing.width)), Number(thing.height))];
    case "cylinder":
    case "mover":
      return [standing(circle(pose.x, pose.y, Number(thing.radius)), Number(thing.height))];
    case "tag":
    case "face":
      return [standing(rectangle(pose, THINNEST, Number(thing.size)), Number(thing.z) + Number(thing.size) / 2)];
    case "gate":
      return [standing(rectangle(pose, THINNEST, Number(thing.width)), GATE_HEIGHT)];
    case "collectable":
      return [standing(circle(pose.x, pose.y, Number(thing.radius)), FLOATING * Number(thing.radius))];
    case "light":
      return [
        { outline: circle(pose.x, pose.y, SHADE.radius), bottom: Number(thing.z), top: Number(thing.z) + SHADE.height },
      ];
    case "prop":
      return [propBody(thing as unknown as PropValues)];
    case "start":
      return [standing(circle(pose.x, pose.y, ROBOT.radius), ROBOT.height)];
    default:
      return [sign(placeOf(world, { sort, index }), thing)];
  }
}

/** The corners of a chain; empty for an object with bodies. */
export function chainOf(world: WorldValues, { sort, index }: Ref): readonly XY[] {
  const thing = listOf(world, sort)[index] ?? {};
  if (sort === "line") return cornersOf(thing as unknown as LineValues);
  return sort === "tour" ? (thing.points as XY[]) : [];
}

function standing(outline: readonly XY[], top: number): Body {
  return { outline, bottom: 0, top };
}

function wallBodies(wall: WallValues): Body[] {
  const width = Math.max(THINNEST, wall.thickness);
  return piecesOf(wall).map(({ pose, length }) => standing(rectangle(pose, length, width), wall.height));
}

/** A goal is flat. */
function sign([x, y]: XY, { radius }: Thing): Body {
  return standing(circle(x, y, typeof radius === "number" ? radius : SIGN), 0);
}

const SIZES = new Map<PropKind, { readonly radius: number; readonly height: number }>();

function propBody({ kind, x, y, scale }: PropValues): Body {
  const { radius, height } = SIZES.get(kind) ?? measured(kind);
  return standing(circle(x, y, radius * scale), height * scale);
}

/** The size of a prop, from its drawing. */
function measured(kind: PropKind) {
  const pose: Pose = { x: 0, y: 0, heading: 0 };
  const floor = { size: [1, 1] } as WorldValues["floor"];
  const object = namedProps({ prop: [{ ...pose, kind, scale: 1, solid: true }], floor }, 0);
  const { max } = new Box3().setFromObject(object);
  const size = { radius: Math.max(max.x, max.y), height: max.z };
  SIZES.set(kind, size);
  return size;
}
