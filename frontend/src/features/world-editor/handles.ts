/** The handles of the selected object: they turn, resize and bend it. */

import type { Sort, Thing } from "../../views/world/plan/sorts";
import type { LineValues, XY } from "../../views/world/scenery/description";
import { between, forward, from, headingOf, type Pose, wrapped } from "../../views/world/scenery/geometry";
import { boundsOf } from "./fields";
import { hasPath } from "./things";

/** Turning with a handle rounds to these degrees. */
const TURN_STEP = 5;
/** mm from an object to the handle that turns it, and from the start of a path. */
const GAP = 140;
const PATH_TURN = 120;
/** Sides that are less to the north than this are neither behind nor in front. */
const LEVEL = 0.1;
/** mm from the edge of an object to the handle of its size, so that a small object can still be dragged. */
const BESIDE = 45;
/** mm from the middle of a prop of usual size to its handle. */
const PROP_REACH = 110;

export interface Handle {
  readonly kind: "turn" | "size" | "corner" | "insert";
  readonly at: XY;
  /** The object after the handle is dragged to a point. */
  pull(to: XY): Thing;
  /** The object without this corner, if it can be removed. */
  remove?(): Thing;
}

export function handlesOf(sort: Sort, thing: Thing): Handle[] {
  if (sort === "wall" || sort === "tour" || (sort === "line" && !hasPath(thing)))
    return corners(thing, sort === "line" && thing.closed === true);
  if (sort === "line") return pathHandles(thing as unknown as LineValues);
  const pose = poseOf(thing);
  const turn = typeof thing.heading === "number" ? [turning(thing, pose, GAP + halfLength(thing))] : [];
  return [...turn, ...sizes(sort, thing, pose)];
}

function poseOf(thing: Thing): Pose {
  return { x: Number(thing.x), y: Number(thing.y), heading: Number(thing.heading ?? 0) };
}

function halfLength(thing: Thing): number {
  return "length" in thing ? Number(thing.length) / 2 : 40;
}

function turning(thing: Thing, pose: Pose, reach: number): Handle {
  return {
    kind: "turn",
    at: from(pose, reach),
    pull: ([x, y]) => ({ ...thing, heading: stepped(headingOf(x - pose.x, y - pose.y)) }),
  };
}

function stepped(heading: number): number {
  return wrapped(Math.round(heading / TURN_STEP) * TURN_STEP);
}

function sizes(sort: Sort, thing: Thing, pose: Pose): Handle[] {
  const size = (key: string, heading: number, factor: number): Handle => ({
    kind: "size",
    at: from({ ...pose, heading }, Number(thing[key]) / factor + BESIDE),
    pull: ([x, y]) => {
      const [dx, dy] = forward(heading);
      const reach = (Math.abs((x - pose.x) * dx + (y - pose.y) * dy) - BESIDE) * factor;
      return { ...thing, [key]: between(Math.round(reach), ...boundsOf(sort, key)) };
    },
  });
  switch (sort) {
    case "box":
    case "door":
      return [size("length", near(pose.heading + 180), 2), size("width", near(pose.heading + 90), 2)];
    case "cylinder":
    case "reach":
    case "stop":
    case "zone":
    case "switch":
    case "mover":
    case "collectable":
      return [size("radius", 0, 1)];
    case "gate":
      return [size("width", near(pose.heading + 90), 2)];
    case "show":
      return thing.radius === null ? [] : [size("radius", 0, 1)];
    case "prop":
      return [scaling(thing, pose)];
    case "tag":
    case "face":
      return [size("size", near(pose.heading + 90), 2)];
    default:
      return [];
  }
}

/** A side of an object, or the opposite one if that is nearer to who looks from the south: in 3D, an object hides what is behind it. */
function near(heading: number): number {
  const [, north] = forward(heading);
  return north > LEVEL ? heading + 180 : heading;
}

/** A handle at the side, which changes how large a prop is. */
function scaling(thing: Thing, pose: Pose): Handle {
  const pull = ([x, y]: XY): Thing => {
    const scale = (Math.hypot(x - pose.x, y - pose.y) - BESIDE) / PROP_REACH;
    return { ...thing, scale: between(Math.round(scale * 20) / 20, ...boundsOf("prop", "scale")) };
  };
  const reach = PROP_REACH * Number(thing.scale) + BESIDE;
  return { kind: "size", at: from({ ...pose, heading: near(pose.heading + 90) }, reach), pull };
}

function corners(thing: Thing, closed: boolean): Handle[] {
  const points = thing.points as XY[];
  const knobs = points.map((at, i): Handle => {
    const others = points.filter((_, k) => k !== i);
    const pull = (to: XY): Thing => ({ ...thing, points: points.map((point, k) => (k === i ? to : point)) });
    return points.length > 2
      ? { kind: "corner", at, pull, remove: () => ({ ...thing, points: others }) }
      : { kind: "corner", at, pull };
  });
  const ends = closed ? [...points.slice(1), points[0] as XY] : points.slice(1);
  return [...ends.map((end, i) => amid(thing, points, i, end)), ...knobs];
}

/** A handle between two corners, which becomes a corner when it is dragged. */
function amid(thing: Thing, points: readonly XY[], index: number, [endX, endY]: XY): Handle {
  const [x, y] = points[index] as XY;
  return {
    kind: "insert",
    at: [(x + endX) / 2, (y + endY) / 2],
    pull: (to) => ({ ...thing, points: points.toSpliced(index + 1, 0, to) }),
  };
}

function pathHandles(line: LineValues): Handle[] {
  const [x, y, heading] = line.start;
  const thing = line as unknown as Thing;
  return [
    { kind: "corner", at: [x, y], pull: (to) => ({ ...thing, start: [...to, heading] }) },
    {
      kind: "turn",
      at: from({ x, y, heading }, PATH_TURN),
      pull: ([toX, toY]) => ({ ...thing, start: [x, y, stepped(headingOf(toX - x, toY - y))] }),
    },
  ];
}
