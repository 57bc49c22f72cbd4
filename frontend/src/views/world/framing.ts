/** Places the camera so that the robot is large and its goals are in sight: all, or if they are too far away, the first. */

import { Vector3 } from "three";

import { isHidden, type Point, type Screen } from "./hiding";
import type { XY } from "./scenery/description";
import { radians } from "./scenery/geometry";

/** Degrees of the picture's height. */
export const FIELD = 36;
/** The part of the picture in which robot and goal are, from its middle. */
export const INNER = 0.8;
/** The robot's part of the picture's height: the least, and the most beside its goal. */
const LEAST = 0.14;
const MOST = 0.3;
/** The robot's least part beside all of its goals: with a smaller one, only the first goal has to be in sight. */
const LEAST_OF_ALL = 0.12;
/** Without a goal: its largest part of the height and of the width, and how far it is from the middle, to leave room ahead. */
const ALONE = { height: 0.42, width: 0.28, aside: 0.38, below: 0.2 };
/** What a turn from the south by 90 degrees costs, and what a robot that looks into the camera is worth. */
const SIDEWAYS = 0.05;
const FACING = 0.04;
/** What a robot costs of which nothing is seen, and a goal that is not seen. */
const HIDDEN = 1;
const GOAL_HIDDEN = 0.05;
/** What it costs if a thing right before the camera fills the picture. */
const COVERED = 0.6;
/** Where that is looked for: across the picture, and up from its middle. */
const ACROSS = [-0.9, -0.6, -0.3, 0, 0.3, 0.6, 0.9] as const;
const UPWARDS = [0, 0.4] as const;
/** Degrees down, and degrees from the south. */
const STEEPNESSES = [30, 27, 33] as const;
const TURNS = [0, 15, -15, 30, -30, 45, -45, 60, -60, 80, -80, 100, -100, 125, -125, 150, -150, 180] as const;
/** Where the camera looks, from the robot to its goal. */
const PARTS = [0, 0.15, 0.3, 0.45, 0.6] as const;
const NEAREST = 260;
const FARTHEST = 9000;
const STEP = 1.07;

const TAN = Math.tan(radians(FIELD / 2));

/** What the picture shows. */
export interface Subject {
  readonly x: number;
  readonly y: number;
  readonly heading: number;
  /** The radius around it, and its height, mm. */
  readonly reach: number;
  readonly height: number;
  /** The first goal, or a line on the floor; null if there is none. */
  readonly goal: XY | null;
  /** The other goals. */
  readonly others?: readonly XY[];
  /** What may hide it. */
  readonly screens: readonly Screen[];
}

export interface View {
  readonly place: Vector3;
  readonly target: Vector3;
}

/**
 * The best of many places for the camera.
 *
 * @param aspect of the part of the picture that nothing covers.
 * @param free its part of the picture's height: with less of it, the robot has to be larger there.
 */
export function frame(subject: Subject, aspect: number, free = 1): View {
  const least = LEAST / free;
  if (subject.others?.length) {
    const eye = best(subject, aspect, least);
    if (eye.shows(subject) && eye.share(subject) >= LEAST_OF_ALL / free) return eye.view;
  }
  return best({ ...subject, others: [] }, aspect, least).view;
}

/** @param least the robot's least part of the height of what is free. */
function best(subject: Subject, aspect: number, least: number): Eye {
  let found: { eye: Eye; score: number } | null = null;
  const isBetter = (score: number) => score > (found?.score ?? Number.NEGATIVE_INFINITY);
  for (const steepness of STEEPNESSES) {
    for (const turn of TURNS) {
      for (const part of subject.goal ? PARTS : PARTS.slice(0, 1)) {
        const eye = nearest(subject, steepness, turn, part, aspect);
        if (!eye) continue;
        const clear = worth(eye.share(subject), least, turn, subject.heading);
        // What is hidden is looked for only where it matters: there are many places.
        const score = isBetter(clear) ? clear - eye.hidden(subject) : clear;
        if (isBetter(score)) found = { eye, score };
      }
    }
  }
  return found?.eye ?? new Eye(subject.x, subject.y, STEEPNESSES[0], 0, aspect);
}

/** How good a picture is; one with too small a robot is worse than all others. */
function worth(share: number, least: number, turn: number, heading: number): number {
  const facing = Math.cos(radians(turn - 90 + heading));
  const score = Math.min(share, MOST) - (SIDEWAYS * Math.abs(turn)) / 90 + FACING * facing;
  return share < least ? score - 1 : score;
}

/** The nearest camera that has everything in the inner part of its picture. */
function nearest(subject: Subject, steepness: number, turn: number, part: number, aspect: number): Eye | null {
  const [goalX, goalY] = middleOf(subject);
  const [x, y] = [subject.x + part * (goalX - subject.x), subject.y + part * (goalY - subject.y)];
  const eye = new Eye(x, y, steepness, turn, aspect);
  for (let distance = NEAREST; distance < FARTHEST; distance *= STEP) {
    eye.distance = distance;
    const isFar = subject.goal ? eye.share(subject) <= MOST : eye.isFarFrom(subject);
    if (!isFar || !eye.shows(subject)) continue;
    if (!subject.goal) eye.leaveRoom(subject.heading);
    return eye;
  }
  return null;
}

/** The middle of the goals; without any, the robot. */
function middleOf({ x, y, goal, others = [] }: Subject): XY {
  const places = goal ? [goal, ...others] : [[x, y] as const];
  const middle = (values: readonly number[]) => (Math.min(...values) + Math.max(...values)) / 2;
  return [middle(places.map(([east]) => east)), middle(places.map(([, north]) => north))];
}

/** A camera that looks at a point on the floor. It makes no vectors: thousands of places are tried. */
class Eye {
  distance = NEAREST;
  private readonly level: number;
  private readonly rise: number;
  private readonly east: number;
  private readonly north: number;

  constructor(
    private x: number,
    private y: number,
    steepness: number,
    turn: number,
    private readonly aspect: number,
  ) {
    const [down, around] = [radians(steepness), radians(turn - 90)];
    this.level = Math.cos(down);
    this.rise = Math.sin(down);
    this.east = Math.cos(around);
    this.north = Math.sin(around);
  }

  get view(): View {
    const target = new Vector3(this.x, this.y, 0);
    const back = new Vector3(this.level * this.east, this.level * this.north, this.rise);
    return { target, place: target.clone().addScaledVector(back, this.distance) };
  }

  /** The part of the picture's height that the robot takes: from its nearest to its farthest upper edge. */
  share({ x, y, reach, height }: Subject): number {
    const [out, across] = [this.east * reach, this.north * reach];
    return (this.up(x - out, y - across, height) - this.up(x + out, y + across, 0)) / 2;
  }

  /** Whether a robot without a goal is small enough. */
  isFarFrom(subject: Subject): boolean {
    const { x, y, reach } = subject;
    return this.share(subject) <= ALONE.height && reach <= ALONE.width * this.depth(x, y, 0) * this.aspect;
  }

  /** Move aside to leave room ahead of a robot in the middle: one that faces right is then on the left. */
  leaveRoom(heading: number): void {
    const half = TAN * this.distance;
    const [forward, left] = [Math.cos(radians(heading)), Math.sin(radians(heading))];
    const right = ALONE.aside * half * this.aspect * (this.east * left - this.north * forward);
    const away = (ALONE.below * half) / this.rise;
    this.x -= right * this.north + away * this.east;
    this.y += right * this.east - away * this.north;
  }

  shows({ x, y, reach, height, goal, others = [] }: Subject): boolean {
    if (goal && !(this.has(goal[0], goal[1], 0) && this.has(goal[0], goal[1], height))) return false;
    if (others.some(([east, north]) => !(this.has(east, north, 0) && this.has(east, north, height)))) return false;
    const r = reach * Math.SQRT1_2;
    for (const east of [x - r, x + r]) {
      for (const north of [y - r, y + r]) {
        if (!this.has(east, north, 0) || !this.has(east, north, height)) return false;
      }
    }
    return true;
  }

  /** What it costs that things stand in front of the robot, its goal and the world. */
  hidden({ x, y, reach, height, goal, screens }: Subject): number {
    const { place } = this.view;
    const from: Point = [place.x, place.y, place.z];
    const isBehind = (point: Point) => isHidden(from, point, screens);
    const middle = height / 2;
    const r = reach * Math.SQRT1_2;
    const body: Point[] = [
      [x, y, height],
      [x, y, middle],
      [x + r, y, middle],
      [x - r, y, middle],
      [x, y + r, middle],
      [x, y - r, middle],
    ];
    const unseen = (HIDDEN * body.filter(isBehind).length) / body.length;
    const view = this.openings();
    const covered = (COVERED * view.filter(isBehind).length) / view.length;
    return unseen + covered + (goal && isBehind([...goal, height]) ? GOAL_HIDDEN : 0);
  }

  /** Points all over the picture, as far away as what it looks at. */
  private openings(): Point[] {
    const half = TAN * this.distance;
    return ACROSS.flatMap((part) => {
      const right = part * half * this.aspect;
      return UPWARDS.map((up): Point => [this.x - right * this.north, this.y + right * this.east, up * half]);
    });
  }

  /** Whether a point is in the inner part of the picture. */
  private has(x: number, y: number, z: number): boolean {
    const depth = this.depth(x, y, z);
    const right = -this.north * (x - this.x) + this.east * (y - this.y);
    return depth > 0 && Math.abs(right) < INNER * depth * this.aspect && Math.abs(this.up(x, y, z)) < INNER;
  }

  /** How far up a point is in the picture, -1 to 1; above it if it is behind the camera. */
  private up(x: number, y: number, z: number): number {
    const back = this.east * (x - this.x) + this.north * (y - this.y);
    const depth = this.depth(x, y, z);
    return depth > 0 ? (this.level * z - this.rise * back) / depth : 2;
  }

  /** Half of the height that the picture has at a point, mm. */
  private depth(x: number, y: number, z: number): number {
    const back = this.east * (x - this.x) + this.north * (y - this.y);
    return TAN * (this.distance - this.level * back - this.rise * z);
  }
}
