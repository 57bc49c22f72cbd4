/** The shapes of each sort of object in the plan. */

import { theme } from "../../../model/preferences";
import { PROP_SIZES } from "../../../protocol/world";
import { iconSource } from "../../../ui/icons";
import { friendly, MARKS } from "../scenery/colours";
import type {
  BoardValues,
  BoxValues,
  CylinderValues,
  FollowValues,
  LampValues,
  LineValues,
  PropKind,
  PropValues,
  ReachValues,
  ShowValues,
  StopValues,
  TagValues,
  TourValues,
  VisitValues,
  WallValues,
  WorldValues,
  XY,
} from "../scenery/description";
import { cornersOf } from "../scenery/geometry";
import { paletteOf, wallColour } from "../scenery/palette";
import { gameShapesOf } from "./game-shapes";
import { posed, rectangle, type Shapes } from "./posed";
import { besideFloor, listOf, type Ref } from "./sorts";
import { chain, svg } from "./svg";
import "./shapes.css";

/** The shapes of an object. */
export function shapesOf(world: WorldValues, { sort, index }: Ref): Shapes {
  // Each sort's list has values of its own type, which the compiler learns from the casts.
  const thing = listOf(world, sort)[index] as never;
  switch (sort) {
    case "line":
      return line(thing);
    case "wall":
      return wall(thing, wallColour(paletteOf(world.theme, theme.value), thing, index));
    case "box":
      return [posed(thing, box(thing))];
    case "cylinder":
      return cylinder(thing);
    case "tag":
      return [posed(thing, ...board(thing, "#20242c", String((thing as TagValues).id)))];
    case "face":
      return [posed(thing, ...board(thing, "#c58a5e", "☺"))];
    case "light":
      return lamp(thing);
    case "prop":
      return [posed(thing, ...prop(thing))];
    case "start":
      return [posed(thing, ...start())];
    case "reach":
      return reach(thing);
    case "follow":
      return follow(world, thing);
    case "visit":
      return visit(world, thing);
    case "tour":
      return tour(thing);
    case "stop":
      return stop(thing);
    case "show":
      return show(thing);
    case "avoid":
    case "collect":
    case "gates":
    case "score":
      return [flag(besideFloor(world, sort))];
    default:
      return gameShapesOf(sort, thing);
  }
}

function line(values: LineValues): Shapes {
  const points = chain(cornersOf(values));
  return [
    svg("polyline", { points, class: "grip", "stroke-width": values.width }),
    svg("polyline", {
      points,
      class: "stroke",
      stroke: friendly(values.colour),
      "stroke-width": values.width,
      "stroke-linejoin": "round",
    }),
  ];
}

function wall({ points, thickness }: WallValues, colour: string): Shapes {
  const attributes = { points: chain(points) };
  return [
    svg("polyline", { ...attributes, class: "grip", "stroke-width": thickness }),
    svg("polyline", { ...attributes, class: "wall outline", "stroke-width": thickness + 6 }),
    svg("polyline", { ...attributes, class: "wall", stroke: colour, "stroke-width": thickness }),
  ];
}

function box(values: BoxValues): SVGElement {
  return rectangle(values, values.mass === null ? "solid" : "solid pushed");
}

function cylinder({ x, y, radius, colour, mass }: CylinderValues): Shapes {
  return [
    svg("circle", {
      cx: x,
      cy: -y,
      r: radius,
      class: mass === null ? "solid" : "solid pushed",
      fill: friendly(colour),
    }),
  ];
}

/** A board from above, with an arrow in front of it. */
function board({ size }: BoardValues, colour: string, text: string): Shapes {
  const half = size / 2;
  return [
    svg("rect", { x: -14, y: -half, width: 18, height: size, class: "solid", fill: colour }),
    svg("path", { d: "M12 -22 L40 0 L12 22 Z", fill: colour }),
    svg("text", { x: -34, y: 0, class: "sign" }, text),
  ];
}

function lamp({ x, y }: LampValues): Shapes {
  const rays = Array.from({ length: 8 }, (_, i) => {
    return svg("line", {
      x1: 34,
      x2: 52,
      y1: 0,
      y2: 0,
      class: "ray",
      transform: `translate(${x} ${-y}) rotate(${45 * i})`,
    });
  });
  return [svg("circle", { cx: x, cy: -y, r: 26, class: "lamp" }), ...rays];
}

/** The colour of each prop, dark enough for the white picture on it. */
const PROP_COLOURS: Readonly<Record<PropKind, string>> = {
  ball: "#f0529c",
  barrel: "#2f7bff",
  block: "#8257e6",
  cone: "#e06a10",
  crate: "#b9803f",
  flowers: "#4fae5a",
  house: "#d77f54",
  lamp: "#5b6680",
  pile: "#dd4b4b",
  planet: "#e58a45",
  post: "#8d80c4",
  rocket: "#6b7a94",
  tree: "#2f9a53",
};

/** A decoration is drawn with a dashed edge: robots drive through it. */
function prop({ kind, scale, solid }: PropValues): Shapes {
  const size = PROP_SIZES[kind];
  const kindOfEdge = solid ? "solid" : "solid decoration";
  const isRound = typeof size === "number";
  const [length, width] = isRound ? [2 * size, 2 * size] : size;
  const place = { x: (-length * scale) / 2, y: (-width * scale) / 2, width: length * scale, height: width * scale };
  const side = 0.7 * Math.min(place.width, place.height);
  const picture = svg("image", { x: -side / 2, y: -side / 2, width: side, height: side, class: "sign" });
  picture.setAttribute("href", iconSource(`prop_${kind}`, "#fff"));
  const edge = svg("rect", { ...place, rx: isRound ? size * scale : 8, class: kindOfEdge, fill: PROP_COLOURS[kind] });
  return [edge, picture];
}

function start(): Shapes {
  return [
    svg("circle", { r: 66, class: "start" }),
    svg("path", { d: "M46 0 L-26 28 L-12 0 L-26 -28 Z", fill: MARKS.start }),
  ];
}

function region([x, y]: XY, radius: number): SVGElement {
  return svg("circle", { cx: x, cy: -y, r: radius, class: "goal" });
}

function flag([x, y]: XY): SVGElement {
  return svg("text", { x, y: -y, class: "flag" }, "⚑");
}

function reach({ x, y, radius }: ReachValues): Shapes {
  return [region([x, y], radius), flag([x, y])];
}

function tour({ points, radius }: TourValues): Shapes {
  const way = svg("polyline", { points: chain(points), class: "halo", "stroke-width": 12 });
  return [way, ...points.map((place) => region(place, radius)), flag(points.at(-1) ?? [0, 0])];
}

/** A region, with an arrow if the robot has to face somewhere. */
function stop({ x, y, radius, heading }: StopValues): Shapes {
  const arrow = svg("path", { d: `M${radius} -22 L${radius + 30} 0 L${radius} 22 Z`, fill: MARKS.open });
  const facing = heading === null ? [] : [posed({ x, y, heading }, arrow)];
  return [region([x, y], radius), ...facing, flag([x, y])];
}

function show({ x, y, radius }: ShowValues): Shapes {
  return radius === null ? [flag([x, y])] : [region([x, y], radius), flag([x, y])];
}

function follow(world: WorldValues, { line: name, distance }: FollowValues): Shapes {
  const found = world.line.find((candidate) => candidate.name === name);
  if (!found) return [];
  const points = cornersOf(found);
  const [x, y] = points.at(-1) ?? [0, 0];
  const wide = found.width + Math.min(distance, 120);
  return [
    svg("polyline", { points: chain(points), class: "halo", "stroke-width": wide }),
    svg("text", { x: x + 50, y: -y - 50, class: "flag" }, "⚑"),
  ];
}

function visit(world: WorldValues, { id, distance }: VisitValues): Shapes {
  const tag = world.tag.find((candidate) => candidate.id === id);
  if (!tag) return [];
  const half = svg("path", { d: `M0 ${-distance} A${distance} ${distance} 0 0 1 0 ${distance} Z`, class: "goal" });
  return [posed(tag, half, svg("text", { x: distance * 0.6, y: 0, class: "flag" }, "⚑"))];
}
