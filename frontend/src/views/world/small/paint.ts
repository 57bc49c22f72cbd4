/** Paints a small picture of a world: the plate, the way, the goals, and the robot. */

import { MARKS } from "../scenery/colours";
import type { SmallCamera } from "./camera";
import { facing, HEIGHT, type Plate, type Sprites, WIDTH } from "./plates";

/** px: the width of the way, the radius of a goal's sign, and the smallest height of a robot's sprite. */
const WAY = 5;
const SIGN = 11;
const SMALLEST = 64;
/** Robots are a little larger than in their world, as they are what one looks at. */
const LARGER = 1.15;

type GoalState = "failed" | "open" | "reached";

/** What changes in a picture. */
export interface Shown {
  /** x, y in mm and heading in degrees clockwise. */
  readonly pose: readonly [number, number, number] | null;
  /** x and y in mm, one after the other. */
  readonly way: readonly number[];
  readonly goals: readonly GoalState[];
}

/** @returns which of the plate's shots is shown: 0 is the nearest. */
export function paint(
  pen: CanvasRenderingContext2D,
  plate: Plate,
  sprites: Sprites | null,
  { pose, way, goals }: Shown,
): number {
  const fitting = plate.shots.findIndex(({ camera }) => isIn(camera, pose, way));
  const number = fitting < 0 ? plate.shots.length - 1 : fitting;
  const { picture, camera } = plate.shots[number]!;
  pen.drawImage(picture, 0, 0, WIDTH, HEIGHT);
  line(pen, camera, way);
  goals.forEach((state, i) => {
    const place = plate.goals[i];
    if (place && state !== "open") sign(pen, at(camera, ...place), state);
  });
  if (pose) robot(pen, camera, sprites, pose);
  return number;
}

function isIn(camera: SmallCamera, pose: Shown["pose"], way: readonly number[]): boolean {
  if (pose && !camera.shows(pose[0], pose[1])) return false;
  for (let i = 0; i + 1 < way.length; i += 2) if (!camera.shows(way[i]!, way[i + 1]!)) return false;
  return true;
}

function at(camera: SmallCamera, x: number, y: number): [number, number] {
  const { right, up } = camera.see(x, y);
  return [((1 + right) / 2) * WIDTH, ((1 - up) / 2) * HEIGHT];
}

function line(pen: CanvasRenderingContext2D, camera: SmallCamera, way: readonly number[]): void {
  pen.strokeStyle = MARKS.trail;
  pen.lineWidth = WAY;
  pen.lineJoin = pen.lineCap = "round";
  pen.beginPath();
  for (let i = 0; i + 1 < way.length; i += 2) pen.lineTo(...at(camera, way[i]!, way[i + 1]!));
  pen.stroke();
}

/** A tick or a cross: colour alone would not be seen by everybody. */
function sign(pen: CanvasRenderingContext2D, [x, y]: [number, number], state: "failed" | "reached"): void {
  const half = SIGN * 0.4;
  pen.fillStyle = MARKS[state];
  pen.beginPath();
  pen.arc(x, y, SIGN, 0, 2 * Math.PI);
  pen.fill();
  pen.strokeStyle = "#ffffff";
  pen.lineWidth = 3;
  pen.beginPath();
  pen.moveTo(x - half, y + (state === "reached" ? 0 : -half));
  if (state === "reached") pen.lineTo(x - half * 0.2, y + half);
  else pen.lineTo(x + half, y + half);
  if (state === "failed") pen.moveTo(x - half, y + half);
  pen.lineTo(x + half, y - half);
  pen.stroke();
}

function robot(
  pen: CanvasRenderingContext2D,
  camera: SmallCamera,
  sprites: Sprites | null,
  [x, y, heading]: readonly [number, number, number],
): void {
  const [left, top] = at(camera, x, y);
  if (!sprites) return dot(pen, left, top);
  const pixels = HEIGHT / (2 * camera.see(x, y).half);
  const size = Math.max(SMALLEST, LARGER * sprites.size * pixels);
  pen.drawImage(facing(sprites, heading), left - size / 2, top - sprites.ground * size, size, size);
}

/** A robot whose sprites are not drawn yet. */
function dot(pen: CanvasRenderingContext2D, x: number, y: number): void {
  pen.fillStyle = MARKS.trail;
  pen.beginPath();
  pen.arc(x, y, SIGN, 0, 2 * Math.PI);
  pen.fill();
}
