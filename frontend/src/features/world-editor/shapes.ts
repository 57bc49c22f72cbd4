/** The shapes of each sort of object in the plan. */

import { css, MARKS } from "../../views/world/scenery/colours";
import type {
  BoardValues,
  BoxValues,
  CylinderValues,
  FollowValues,
  LampValues,
  LineValues,
  ReachValues,
  TagValues,
  VisitValues,
  WallValues,
  WorldValues,
} from "../../views/world/scenery/description";
import { cornersOf, type Pose } from "../../views/world/scenery/geometry";
import { chain, svg } from "./svg";
import { listOf, type Ref } from "./things";

type Shapes = SVGElement[];

/** The shapes of an object. */
export function shapesOf(world: WorldValues, { sort, index }: Ref): Shapes {
  // Each sort's list has values of its own type, which the compiler learns from the casts.
  const thing = listOf(world, sort)[index] as never;
  switch (sort) {
    case "line":
      return line(thing);
    case "wall":
      return wall(thing);
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
    case "start":
      return [posed(thing, ...start())];
    case "reach":
      return reach(thing);
    case "follow":
      return follow(world, thing);
    case "visit":
      return visit(world, thing);
  }
}

/** Objects with a pose, drawn facing east. */
function posed({ x, y, heading }: Pose, ...shapes: Shapes): SVGElement {
  return svg("g", { transform: `translate(${x} ${-y}) rotate(${heading})` }, ...shapes);
}

function line(values: LineValues): Shapes {
  const points = chain(cornersOf(values));
  return [
    svg("polyline", { points, class: "grip", "stroke-width": values.width }),
    svg("polyline", {
      points,
      class: "stroke",
      stroke: css(values.colour),
      "stroke-width": values.width,
      "stroke-linejoin": "round",
    }),
  ];
}

function wall({ points, thickness, colour }: WallValues): Shapes {
  const attributes = { points: chain(points) };
  return [
    svg("polyline", { ...attributes, class: "grip", "stroke-width": thickness }),
    svg("polyline", { ...attributes, class: "wall outline", "stroke-width": thickness + 6 }),
    svg("polyline", { ...attributes, class: "wall", stroke: css(colour), "stroke-width": thickness }),
  ];
}

function box({ length, width, colour, mass }: BoxValues): SVGElement {
  const place = { x: -length / 2, y: -width / 2, width: length, height: width };
  return svg("rect", { ...place, class: mass === null ? "solid" : "solid pushed", fill: css(colour) });
}

function cylinder({ x, y, radius, colour, mass }: CylinderValues): Shapes {
  return [
    svg("circle", { cx: x, cy: -y, r: radius, class: mass === null ? "solid" : "solid pushed", fill: css(colour) }),
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

function start(): Shapes {
  return [
    svg("circle", { r: 66, class: "start" }),
    svg("path", { d: "M46 0 L-26 28 L-12 0 L-26 -28 Z", fill: MARKS.start }),
  ];
}

function reach({ x, y, radius }: ReachValues): Shapes {
  return [svg("circle", { cx: x, cy: -y, r: radius, class: "goal" }), svg("text", { x, y: -y, class: "flag" }, "⚑")];
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
