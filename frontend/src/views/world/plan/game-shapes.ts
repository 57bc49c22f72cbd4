/** The shapes of the things of games in the plan. */

import { friendly } from "../scenery/colours";
import type {
  CollectableKind,
  CollectableValues,
  GateValues,
  MoverValues,
  SwitchValues,
  XY,
  ZoneValues,
} from "../scenery/description";
import { COLLECTABLE_COLOURS, PLATE } from "../scenery/game-colours";
import { posed, rectangle, type Shapes } from "./posed";
import type { Sort } from "./sorts";
import { chain, svg } from "./svg";

type GameSort = Extract<Sort, "zone" | "switch" | "gate" | "door" | "mover" | "collectable">;

const GATE = "#2f6fed";
/** What a thing to collect looks like from above. */
const SYMBOLS: Readonly<Record<CollectableKind, string>> = {
  star: "★",
  coin: "¢",
  gem: "◆",
  heart: "♥",
  cherry: "●",
  battery: "↯",
  key: "⚷",
  flag: "⚑",
  bug: "✶",
  ghost: "☁",
};

/** The radius of a gate's posts, mm. */
const POST = 14;

/** The shapes of a thing of a game. */
export function gameShapesOf(sort: GameSort, thing: never): Shapes {
  switch (sort) {
    case "zone":
      return [area(thing, friendly((thing as ZoneValues).colour))];
    case "switch":
      return [area(thing, PLATE)];
    case "gate":
      return [posed(thing, ...gate(thing))];
    case "door":
      return [posed(thing, rectangle(thing, "solid"))];
    case "mover":
      return [...way(thing), ...mover(thing)];
    case "collectable":
      return [...way(thing), ...collectable(thing)];
  }
}

function area({ x, y, radius }: ZoneValues | SwitchValues, colour: string): SVGElement {
  return svg("circle", {
    cx: x,
    cy: -y,
    r: radius,
    fill: colour,
    "fill-opacity": 0.25,
    stroke: colour,
    "stroke-width": 6,
  });
}

/** Two posts, and an arrow in the direction in which one passes. */
function gate({ width }: GateValues): Shapes {
  const posts = [-1, 1].map((side) => svg("circle", { cx: 0, cy: (side * width) / 2, r: POST, fill: GATE }));
  const bar = svg("line", { x1: 0, x2: 0, y1: -width / 2, y2: width / 2, stroke: GATE, "stroke-width": POST });
  return [...posts, bar, svg("path", { d: "M12 -22 L40 0 L12 22 Z", fill: GATE })];
}

function mover({ x, y, radius, colour }: MoverValues): Shapes {
  return [svg("circle", { cx: x, cy: -y, r: radius, class: "solid", fill: friendly(colour) })];
}

function collectable({ x, y, radius, kind }: CollectableValues): Shapes {
  return [
    svg("circle", { cx: x, cy: -y, r: radius, class: "solid", fill: COLLECTABLE_COLOURS[kind] }),
    svg("text", { x, y: -y, class: "sign" }, SYMBOLS[kind]),
  ];
}

/** Where a thing goes by itself: its path, or the square in which it wanders. */
function way({ x, y, path, closed, wander }: MoverValues | CollectableValues): Shapes {
  if (wander > 0)
    return [svg("rect", { x: x - wander, y: -y - wander, width: 2 * wander, height: 2 * wander, class: "way" })];
  if (path.length === 0) return [];
  return [svg("polyline", { points: chain([[x, y], ...path, ...(closed ? [[x, y] as XY] : [])]), class: "way" })];
}
