/** The camera of a small picture: it looks from the south at a part of the floor, and never moves. */

import type { Scene } from "../../../protocol/messages";
import { goalPlaces } from "../marks";
import type { XY } from "../scenery/description";
import { radians } from "../scenery/geometry";

/** Degrees of the picture's height, and degrees down. */
export const FIELD = 30;
export const STEEPNESS = 37;
/** The part of the picture, from its middle, in which everything is that has to be seen. */
const INNER = 0.86;
/** What is on the floor is up to this high, mm. */
const HEIGHT = 120;
/** mm around a place, and the least size of what is shown. */
const AROUND = 110;
const LEAST = 460;
const ROUNDS = 12;
/** What is up to so many times as far away as the nearest goal is shown with it, such as all corners of a square. */
const ABOUT = 2;

const ORIGIN: XY = [0, 0];

const TAN = Math.tan(radians(FIELD / 2));
const [LEVEL, RISE] = [Math.cos(radians(STEEPNESS)), Math.sin(radians(STEEPNESS))];

/** A part of the floor, mm. */
export interface Area {
  readonly west: number;
  readonly east: number;
  readonly south: number;
  readonly north: number;
}

/** Where something is in a picture: from -1 to 1, to the right and up, and the height of half the picture there in mm. */
export interface Seen {
  readonly right: number;
  readonly up: number;
  readonly half: number;
}

/** Looks at a point on the floor from a distance, mm. */
export class SmallCamera {
  constructor(
    readonly target: XY,
    readonly distance: number,
    readonly aspect: number,
  ) {}

  /** Where it is. */
  get place(): readonly [number, number, number] {
    return [this.target[0], this.target[1] - this.distance * LEVEL, this.distance * RISE];
  }

  see(x: number, y: number, z = 0): Seen {
    const [across, away] = [x - this.target[0], y - this.target[1]];
    const half = TAN * (this.distance + away * LEVEL - z * RISE);
    return { right: across / half / this.aspect, up: (away * RISE + z * LEVEL) / half, half };
  }

  /** Whether a place on the floor is in the picture. */
  shows(x: number, y: number): boolean {
    const { right, up, half } = this.see(x, y);
    return half > 0 && Math.abs(right) < 0.97 && Math.abs(up) < 0.97;
  }
}

/** The nearest camera that has an area in its picture. */
export function cameraOver({ west, east, south, north }: Area, aspect: number): SmallCamera {
  const corners = [south, north].flatMap((y) =>
    [west, east].flatMap((x) => [0, HEIGHT].map((z) => [x, y, z] as const)),
  );
  const middle = (west + east) / 2;
  let camera = new SmallCamera([middle, (south + north) / 2], 2 * Math.max(east - west, north - south) + LEAST, aspect);
  for (let round = 0; round < ROUNDS; round++) {
    const seen = corners.map((corner) => camera.see(...corner));
    const [top, bottom] = [Math.max(...seen.map(({ up }) => up)), Math.min(...seen.map(({ up }) => up))];
    const filled = Math.max((top - bottom) / 2, ...seen.map(({ right }) => Math.abs(right))) / INNER;
    const shift = ((top + bottom) / 2) * ((TAN * camera.distance) / RISE);
    camera = new SmallCamera([middle, camera.target[1] + shift], camera.distance * filled, aspect);
  }
  return camera;
}

/**
 * What may be shown of a world, the smallest first: what is near the start, more around it, everything that the world is
 * about, and its floor.
 *
 * A robot that leaves one of them is shown in the next.
 */
export function areasOf({ world, lines, start }: Pick<Scene, "world" | "lines" | "start">): Area[] {
  const [width, depth] = world.floor.size;
  const floor = { west: -width / 2, east: width / 2, south: -depth / 2, north: depth / 2 };
  const starts = [...(start ? [[start[0], start[1]] as const] : []), ...world.start.map(({ x, y }) => [x, y] as const)];
  const aims = [...goalPlaces(world), ...lines.flat()];
  if (aims.length === 0) return [floor];
  const [first = [0, 0]] = starts;
  const near = nearest(aims, first);
  const small = around([...starts, ...near]);
  return [small, larger(small), around([...starts, ...aims]), floor].sort((one, other) => sizeOf(one) - sizeOf(other));
}

/** The area of everything that is in a world and of its goals; of an empty one, what is around its starts. */
export function areaOfAll({ world, lines }: Pick<Scene, "world" | "lines">): Area {
  const things = [...world.box, ...world.cylinder, ...world.tag, ...world.face, ...world.start];
  const corners = [...world.wall.flatMap(({ points }) => points), ...lines.flat(), ...goalPlaces(world)];
  return around([...things.map(({ x, y }) => [x, y] as const), ...corners, ...(things.length ? [] : [ORIGIN])]);
}

/** Twice as wide and deep. */
function larger({ west, east, south, north }: Area): Area {
  const [x, y] = [(east - west) / 2, (north - south) / 2];
  return { west: west - x, east: east + x, south: south - y, north: north + y };
}

function sizeOf({ west, east, south, north }: Area): number {
  return (east - west) * (north - south);
}

/** The places that are about as near as the nearest one, which is not where the robot is. */
function nearest(aims: readonly (readonly [number, number])[], [x, y]: readonly [number, number]) {
  const away = ([east, north]: readonly [number, number]) => Math.hypot(east - x, north - y);
  const distances = aims.map(away).filter((distance) => distance > AROUND);
  const most = ABOUT * Math.min(...distances);
  return aims.filter((aim) => away(aim) <= Math.max(AROUND, most));
}

function around(places: readonly (readonly [number, number])[]): Area {
  const [west, east] = range(places.map(([x]) => x));
  const [south, north] = range(places.map(([, y]) => y));
  return { west, east, south, north };
}

function range(values: readonly number[]): [number, number] {
  const [least, most] = [Math.min(...values) - AROUND, Math.max(...values) + AROUND];
  const lacking = Math.max(0, LEAST - (most - least)) / 2;
  return [least - lacking, most + lacking];
}
