/** The objects of a world, handled in the same way for all sorts. */

import {
  besideFloor,
  isGoal,
  listOf,
  type Ref,
  SORTS,
  type Sort,
  type Thing,
  thingAt,
} from "../../views/world/plan/sorts";
import type { LineValues, WorldValues, XY } from "../../views/world/scenery/description";
import { between, cornersOf, radians, wrapped } from "../../views/world/scenery/geometry";
import { freeTag } from "./creating";
import { boundsOf } from "./fields";
import { manned, withStartNamed } from "./teams";

/** Objects that may be outside the floor. */
const FREE: readonly Sort[] = ["wall", "line", "prop", "reach", "tour", "stop", "show"];
/** A grid of 5 mm or less would be too fine to notice. */
export const GRID = 10;
const FARTHEST = 5000;

function withList(world: WorldValues, sort: Sort, list: readonly Thing[]): WorldValues {
  if (isGoal(sort)) return { ...world, goal: { ...world.goal, [sort]: list } };
  return manned(varied({ ...world, [sort]: list }));
}

const VARIED: readonly Sort[] = ["box", "cylinder", "tag", "face"];

/** The name by which a world's variants move an object. */
function movedAs(sort: Sort, thing: Thing): string {
  if (sort === "tag") return `tag ${thing.id}`;
  return sort === "face" ? `face ${thing.emotion}` : String(thing.name);
}

/** The world without bounds for objects that it no longer has. */
function varied(world: WorldValues): WorldValues {
  const { vary } = world;
  if (!vary) return world;
  const names = new Set(VARIED.flatMap((sort) => listOf(world, sort).map((thing) => movedAs(sort, thing))));
  return { ...world, vary: { ...vary, thing: vary.thing.filter(({ name }) => names.has(name)) } };
}

/** The world without objects, and without the rules and teams of a game. */
export function emptied(world: WorldValues): WorldValues {
  const none = (sorts: readonly Sort[]) => Object.fromEntries(sorts.map((sort) => [sort, []]));
  const lists = none(SORTS.filter((sort) => !isGoal(sort)));
  const goal = none(SORTS.filter(isGoal)) as unknown as WorldValues["goal"];
  return { ...world, ...lists, goal, game: null, team: [], vary: null };
}

/** The world with one object replaced by another. */
export function replaced(world: WorldValues, ref: Ref, thing: Thing): WorldValues {
  const before = thingAt(world, ref);
  const list = listOf(world, ref.sort).map((old, i) => (i === ref.index ? thing : old));
  const after = before ? withRenamed(world, ref.sort, before, thing) : world;
  return withList(after, ref.sort, list);
}

/** The world in which others still name an object that is changed. */
function withRenamed(world: WorldValues, sort: Sort, before: Thing, after: Thing): WorldValues {
  if (sort === "start") return withStartNamed(world, String(before.name), String(after.name));
  return renamed(world, movedAs(sort, before), movedAs(sort, after));
}

/** The world in which a renamed object still moves as far in variants. */
function renamed(world: WorldValues, before: string, after: string): WorldValues {
  const bound = world.vary?.thing.find(({ name }) => name === before);
  if (!world.vary || !bound || before === after) return world;
  return { ...world, vary: { ...world.vary, thing: [...world.vary.thing, { ...bound, name: after }] } };
}

export function removed(world: WorldValues, ref: Ref): WorldValues {
  return withList(
    world,
    ref.sort,
    listOf(world, ref.sort).filter((_, i) => i !== ref.index),
  );
}

/** The world with one more object, and a reference to that object. */
export function added(world: WorldValues, sort: Sort, thing: Thing): [WorldValues, Ref] {
  const list = listOf(world, sort);
  return [withList(world, sort, [...list, withName(world, sort, thing)]), { sort, index: list.length }];
}

/** Lines, starts and goals are referred to by name, so names are unique. */
function withName(world: WorldValues, sort: Sort, thing: Thing): Thing {
  const goals: readonly { name: string }[] = Object.values(world.goal).flat();
  const others = isGoal(sort) ? goals : sort === "line" || sort === "start" ? world[sort] : null;
  if (!others) return thing;
  const taken = new Set(others.map(({ name }) => name));
  const stem = String(thing.name).replace(/ \d+$/, "");
  let name = String(thing.name);
  for (let count = 2; taken.has(name); count++) name = `${stem} ${count}`;
  return { ...thing, name };
}

/** The world with a copy beside an object, and a reference to the copy. */
export function duplicated(world: WorldValues, ref: Ref): [WorldValues, Ref] {
  const copy = moved(world, ref, 5 * GRID, -5 * GRID) ?? {};
  return added(world, ref.sort, ref.sort === "tag" ? { ...copy, id: freeTag(world) } : copy);
}

/** Round to the grid. */
export function snapped(value: number, grid = GRID): number {
  return Math.round(value / grid) * grid;
}

/** The nearest valid position, on the floor if the sort requires it. */
export function allowedPlace(world: WorldValues, sort: Sort, [x, y]: XY): XY {
  const [east, north] = FREE.includes(sort) ? [FARTHEST, FARTHEST] : [world.floor.size[0] / 2, world.floor.size[1] / 2];
  return [between(x, -east, east), between(y, -north, north)];
}

/** An object moved by mm; null if there is no such object. */
export function moved(world: WorldValues, ref: Ref, dx: number, dy: number): Thing | null {
  const thing = thingAt(world, ref);
  if (!thing) return null;
  const shift = ([x, y]: XY): XY => allowedPlace(world, ref.sort, [x + dx, y + dy]);
  if (hasPath(thing)) {
    const [x, y, heading] = (thing as unknown as LineValues).start;
    return { ...thing, start: [...shift([x, y]), heading] };
  }
  if ("points" in thing) return { ...thing, points: (thing.points as XY[]).map(shift) };
  if (!("x" in thing)) return thing;
  const [x, y] = shift([Number(thing.x), Number(thing.y)]);
  // What moves by itself takes its way along.
  return "path" in thing ? { ...thing, x, y, path: (thing.path as XY[]).map(shift) } : { ...thing, x, y };
}

/** An object turned clockwise by degrees; unchanged if its sort has no heading. */
export function turned(thing: Thing, degrees: number): Thing {
  if (typeof thing.heading === "number") return { ...thing, heading: wrapped(thing.heading + degrees) };
  if (hasPath(thing)) {
    const [x, y, heading] = (thing as unknown as LineValues).start;
    return { ...thing, start: [x, y, wrapped(heading + degrees)] };
  }
  if ("points" in thing) return { ...thing, points: turnedPoints(thing.points as XY[], degrees) };
  return thing;
}

/** What makes an object of a sort larger. */
const SIZES: Readonly<Partial<Record<Sort, readonly string[]>>> = {
  box: ["length", "width", "height"],
  cylinder: ["radius", "height"],
  tag: ["size"],
  face: ["size"],
  prop: ["scale"],
  reach: ["radius"],
  tour: ["radius"],
  stop: ["radius"],
  show: ["radius"],
  zone: ["radius"],
  switch: ["radius"],
  gate: ["width"],
  door: ["length", "height"],
  mover: ["radius", "height"],
  collectable: ["radius"],
};
/** Sizes below this are multiples of a usual size, not millimetres. */
const MULTIPLES = 10;

/** An object larger by a factor; unchanged if its sort has no size. */
export function enlarged(sort: Sort, thing: Thing, factor: number): Thing {
  if (sort === "wall" || (sort === "line" && !hasPath(thing))) {
    return { ...thing, points: stretched(thing.points as XY[], factor) };
  }
  const keys = (SIZES[sort] ?? []).filter((key) => typeof thing[key] === "number");
  return { ...thing, ...Object.fromEntries(keys.map((key) => [key, enlargedValue(sort, key, thing, factor)])) };
}

function enlargedValue(sort: Sort, key: string, thing: Thing, factor: number): number {
  const size = Number(thing[key]) * factor;
  const [least, most] = boundsOf(sort, key);
  return between(most < MULTIPLES ? Math.round(size * 100) / 100 : Math.round(size), least, most);
}

function stretched(points: readonly XY[], factor: number): XY[] {
  const [x, y] = middleOf(points);
  const far = (value: number) => between(Math.round(value), -FARTHEST, FARTHEST);
  return points.map(([px, py]) => [far(x + (px - x) * factor), far(y + (py - y) * factor)]);
}

function turnedPoints(points: readonly XY[], degrees: number): XY[] {
  const [x, y] = middleOf(points);
  const [cos, sin] = [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  return points.map(([px, py]) => {
    const [dx, dy] = [px - x, py - y];
    return [tenths(x + dx * cos + dy * sin), tenths(y + dy * cos - dx * sin)];
  });
}

function tenths(value: number): number {
  return Math.round(value * 10) / 10;
}

export function middleOf(points: readonly XY[]): XY {
  const sum = points.reduce(([x, y], [px, py]): XY => [x + px, y + py], [0, 0]);
  return [sum[0] / points.length, sum[1] / points.length];
}

/** Whether it is a line that is described by a start and segments instead of corners. */
export function hasPath(thing: Thing): boolean {
  return "start" in thing && Array.isArray(thing.path) && thing.path.length > 0;
}

/** The position of an object, for its description and for the plan. */
export function placeOf(world: WorldValues, { sort, index }: Ref): XY {
  const thing = listOf(world, sort)[index];
  if (!thing) return [0, 0];
  if (sort === "follow") return lineMiddle(world.line.find(({ name }) => name === thing.line));
  if (sort === "line") return lineMiddle(thing as unknown as LineValues);
  if (sort === "visit") {
    const tag = world.tag.find(({ id }) => id === thing.id);
    return tag ? [tag.x, tag.y] : [0, 0];
  }
  if (!("x" in thing || "points" in thing)) return besideFloor(world, sort);
  if (sort === "wall" || sort === "tour") return middleOf(thing.points as XY[]);
  return [Number(thing.x), Number(thing.y)];
}

function lineMiddle(line: LineValues | undefined): XY {
  const points = line ? cornersOf(line) : [];
  return points.length ? middleOf(points) : [0, 0];
}
