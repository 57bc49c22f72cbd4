/** The keys of the world while it has the focus. */

import type { Signal } from "@preact/signals";
import type { Tool } from "../../ui/tool";
import type { Cameras } from "./cameras";

/** Degrees by which one key press turns the camera. */
const CAMERA_STEP = 10;
/** mm, without and with Shift. */
const STEPS = [10, 100] as const;
/** Degrees. */
const TURNS = [5, 45] as const;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
/** Some keyboards have < and > on these keys when Shift is held, others ; and :. */
const TURN_KEYS: Readonly<Record<string, number>> = { ",": -1, "<": -1, ";": -1, ".": 1, ">": 1, ":": 1 };

/** Placing the robot with keys. */
export interface KeyPlacing {
  readonly on: Signal<boolean>;
  nudge(east: number, north: number, turn: number): void;
}

export function worldKeys(
  cameras: Cameras,
  tools: readonly Tool[],
  placing: KeyPlacing,
): (event: KeyboardEvent) => void {
  return (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const done = (placing.on.value && place(event, placing)) || look(event, cameras) || use(event, tools);
    if (done) event.preventDefault();
  };
}

function place(event: KeyboardEvent, { on, nudge }: KeyPlacing): boolean {
  const [east, north] = ARROWS[event.key] ?? [0, 0];
  const turn = TURN_KEYS[event.key] ?? 0;
  const coarse = event.shiftKey ? 1 : 0;
  if (east || north || turn) nudge(east * STEPS[coarse], north * STEPS[coarse], turn * TURNS[coarse]);
  else if (event.key === "Escape" || event.key === "Enter") on.value = false;
  else return false;
  return true;
}

function look(event: KeyboardEvent, cameras: Cameras): boolean {
  const arrow = ARROWS[event.key];
  if (!arrow) return false;
  cameras.turn(arrow[0] * CAMERA_STEP, arrow[1] * CAMERA_STEP);
  return true;
}

function use(event: KeyboardEvent, tools: readonly Tool[]): boolean {
  const key = event.key === "=" ? "+" : event.key.toLowerCase();
  const tool = tools.find((candidate) => candidate.key === key);
  if (!tool || tool.enabled?.value === false) return false;
  tool.act();
  return true;
}
