/** Decoration: what a theme puts around the floor, and what a world puts anywhere. */

import { Group, type Object3D, TorusGeometry } from "three";

import { PROP_SIZES } from "../../../protocol/world";
import type { PropKind, PropValues, Theme, WorldValues, XY } from "./description";
import { circle, shadows } from "./shadows";
import { ball, cone, cylinder, drum, Parts, roundedBox } from "./solids";

/** Adds a thing of a size to a place on the ground. */
type Prop = (parts: Parts, x: number, y: number, z: number, size: number) => void;

const tree =
  (leaves: string, light: string): Prop =>
  (parts, x, y, z, size) => {
    parts.add(cone(22 * size, 15 * size, 110 * size), "#b07a4a", x, y, z + 55 * size);
    parts.add(ball(88 * size), leaves, x, y, z + 165 * size);
    parts.add(ball(62 * size), light, x + 34 * size, y - 14 * size, z + 232 * size);
  };

const trafficCone: Prop = (parts, x, y, z, size) => {
  parts.add(roundedBox(96 * size, 96 * size, 14 * size, 6), "#ff7a1a", x, y, z + 7 * size);
  parts.add(cone(36 * size, 9 * size, 118 * size), "#ff7a1a", x, y, z + 70 * size);
  parts.add(cone(27.5 * size, 21 * size, 28 * size), "#ffffff", x, y, z + 72 * size);
};

const block =
  (colour: string): Prop =>
  (parts, x, y, z, size) =>
    parts.add(roundedBox(130 * size, 130 * size, 130 * size, 9), colour, x, y, z + 65 * size);

const pile: Prop = (parts, x, y, z, size) => {
  block("#ef4444")(parts, x - 80 * size, y, z, size);
  block("#38a3ff")(parts, x + 80 * size, y + 10 * size, z, size);
  block("#ffc933")(parts, x, y + 4 * size, z + 132 * size, size);
};

const toyBall =
  (colour: string): Prop =>
  (parts, x, y, z, size) =>
    parts.add(ball(70 * size), colour, x, y, z + 70 * size);

const house =
  (colour: string, storeys: number): Prop =>
  (parts, x, y, z, size) => {
    const [width, storey] = [210 * size, 90 * size];
    const height = storey * storeys + 40 * size;
    parts.add(roundedBox(width, width, height, 12), colour, x, y, z + height / 2);
    for (let floor = 0; floor < storeys; floor++) {
      for (const side of [-1, 0, 1]) {
        const up = z + storey * (floor + 0.65);
        const window = roundedBox(38 * size, width + 6, 46 * size, 2);
        parts.add(window, "#ffe9a8", x + side * 62 * size, y, up);
        parts.add(roundedBox(width + 6, 38 * size, 46 * size, 2), "#ffe9a8", x, y + side * 62 * size, up);
      }
    }
  };

const streetLamp: Prop = (parts, x, y, z, size) => {
  parts.add(drum(30 * size, 20 * size, 6), "#4a5468", x, y, z + 10 * size);
  parts.add(cylinder(7 * size, 330 * size), "#4a5468", x, y, z + 165 * size);
  parts.add(ball(36 * size), "#fff0b3", x, y, z + 350 * size);
};

const crate: Prop = (parts, x, y, z, size) => {
  const side = 150 * size;
  parts.add(roundedBox(side, side, side, 6), "#d9a566", x, y, z + side / 2);
  for (const edge of [-1, 1]) {
    const slat = roundedBox(side + 8, side + 8, 18 * size, 2);
    parts.add(slat, "#b0793e", x, y, z + side * (0.5 + 0.38 * edge));
  }
};

const crates: Prop = (parts, x, y, z, size) => {
  crate(parts, x - 82 * size, y, z, size);
  crate(parts, x + 82 * size, y + 14 * size, z, size);
  crate(parts, x - 10 * size, y + 6 * size, z + 150 * size, size);
};

const barrel: Prop = (parts, x, y, z, size) => {
  parts.add(drum(62 * size, 160 * size, 12), "#2f7bff", x, y, z + 80 * size);
  for (const up of [45, 115]) parts.add(drum(65 * size, 14 * size, 2), "#1d4fb8", x, y, z + up * size);
};

const planet =
  (colour: string, ring: string | null): Prop =>
  (parts, x, y, z, size) => {
    parts.add(ball(110 * size), colour, x, y, z + 260 * size);
    if (ring) parts.add(new TorusGeometry(170 * size, 13 * size, 6, 24).rotateX(0.5), ring, x, y, z + 260 * size);
  };

const rocket: Prop = (parts, x, y, z, size) => {
  parts.add(drum(48 * size, 220 * size, 20), "#f7f8fb", x, y, z + 160 * size);
  parts.add(cone(47 * size, 4 * size, 90 * size), "#ef4444", x, y, z + 312 * size);
  parts.add(drum(26 * size, 100 * size, 6).rotateX(Math.PI / 2), "#38a3ff", x, y, z + 210 * size);
  for (const turn of [0, 1, 2, 3]) {
    const fin = roundedBox(70 * size, 12 * size, 90 * size, 2)
      .translate(52 * size, 0, 0)
      .rotateZ((turn * Math.PI) / 2);
    parts.add(fin, "#ef4444", x, y, z + 60 * size);
  }
};

const flowers: Prop = (parts, x, y, z, size) => {
  parts.add(ball(80 * size), "#4fae5a", x, y, z + 30 * size);
  const colours = ["#f0529c", "#ffc933", "#ffffff", "#8257e6", "#ef4444"];
  colours.forEach((colour, i) => {
    const angle = (i * 2 * Math.PI) / colours.length;
    const [east, north] = [56 * size * Math.cos(angle), 56 * size * Math.sin(angle)];
    parts.add(ball(18 * size), colour, x + east, y + north, z + 92 * size);
  });
};

const post =
  (colour: string): Prop =>
  (parts, x, y, z, size) => {
    parts.add(cone(60 * size, 44 * size, 150 * size, 4).rotateZ(Math.PI / 4), "#efeaff", x, y, z + 75 * size);
    parts.add(ball(52 * size), colour, x, y, z + 195 * size);
  };

/** The things of a theme, in turn around the floor: tall ones first, which stand in the north. */
const PROPS: Readonly<Record<Theme, { readonly tall: readonly Prop[]; readonly low: readonly Prop[] }>> = {
  playground: {
    tall: [tree("#46b96b", "#58c877"), pile, tree("#63c74d", "#78d660")],
    low: [toyBall("#f0529c"), trafficCone, block("#8257e6"), trafficCone, toyBall("#ff8a1f")],
  },
  city: {
    tall: [
      house("#e58f65", 3),
      house("#7c9cc9", 5),
      house("#d9c7a0", 2),
      tree("#46b96b", "#58c877"),
      house("#94b8a4", 4),
    ],
    low: [trafficCone, streetLamp, trafficCone, streetLamp],
  },
  space: {
    tall: [planet("#ff9f5a", "#ffd9a0"), rocket, planet("#7cc4ff", null)],
    low: [toyBall("#8a84b8"), planet("#c77dff", null), toyBall("#6d679c")],
  },
  warehouse: { tall: [crates, crates, barrel], low: [barrel, trafficCone, crates, trafficCone] },
  garden: {
    tall: [tree("#3f9b4f", "#56b563"), flowers, tree("#5bb548", "#74c95f"), tree("#3f9b4f", "#56b563")],
    low: [flowers, flowers, flowers, flowers],
  },
  night: {
    tall: [tree("#2c8f5a", "#3aa36c"), streetLamp, tree("#2f7f68", "#3b9a7e")],
    low: [streetLamp, block("#5b4bb0"), streetLamp],
  },
  maze: {
    tall: [post("#8257e6"), post("#12a594"), post("#f0529c")],
    low: [post("#ffc933"), post("#38a3ff"), post("#ff8a1f")],
  },
};
/** mm from the floor to the things around it. */
const AWAY = 330;
/** Where things are along the north, from west to east, and along the sides, from north to south: -1 to 1. */
const NORTH = [-0.95, -0.45, 0.1, 0.6, 1] as const;
const SIDES = [0.75, 0.1, -0.6] as const;

/** @param depth of the ground below the floor, mm. */
export function props(theme: Theme, [width, length]: XY, depth: number): Object3D {
  const { tall, low } = PROPS[theme];
  const parts = new Parts();
  const [east, north] = [width / 2 + AWAY, length / 2 + AWAY];
  const places: XY[] = [];
  const put = (prop: Prop | undefined, x: number, y: number, size: number): void => {
    prop?.(parts, x, y, -depth, size);
    places.push([x, y]);
  };
  NORTH.forEach((along, i) => {
    put(tall[i % tall.length], along * east, north + 70 * (i % 3), 1.1 + 0.15 * (i % 2));
  });
  SIDES.forEach((along, i) => {
    put(low[(2 * i) % low.length], -east - 40 * i, along * north, 1);
    put(low[(2 * i + 1) % low.length], east + 40 * i, (along - 0.15) * north, 1);
  });
  const blobs = shadows(places.map(([x, y]) => circle(x, y, 70)));
  blobs.position.z = -depth;
  const mesh = parts.mesh();
  mesh.castShadow = false;
  return new Group().add(mesh, blobs);
}

/** The props that worlds may name. Their bodies are as wide: a test compares them with `PROP_SIZES`. */
export const NAMED: Readonly<Record<PropKind, Prop>> = {
  ball: toyBall("#f0529c"),
  barrel,
  block: block("#8257e6"),
  cone: trafficCone,
  crate,
  flowers,
  house: house("#e58f65", 2),
  lamp: streetLamp,
  pile,
  planet: planet("#ff9f5a", "#ffd9a0"),
  post: post("#12a594"),
  rocket,
  tree: tree("#46b96b", "#58c877"),
};
/** Of the half side of a square, how far its round shadow reaches. */
const SHADOW_OF_SQUARE = 1.25;

/** The radius of the shadow of a prop of usual size, mm. */
function shadowOf(kind: PropKind): number {
  const size = PROP_SIZES[kind];
  return typeof size === "number" ? size : (SHADOW_OF_SQUARE * (size[0] + size[1])) / 4;
}

/**
 * The props of a world, on its floor or on the ground around it.
 *
 * @param depth of the ground below the floor, mm.
 */
export function namedProps({ prop: named, floor }: Pick<WorldValues, "prop" | "floor">, depth: number): Object3D {
  const parts = new Parts();
  const outlines: Record<"floor" | "ground", XY[][]> = { floor: [], ground: [] };
  for (const prop of named) {
    const onFloor = isOn(floor.size, prop);
    const single = new Parts();
    NAMED[prop.kind](single, 0, 0, 0, prop.scale);
    parts.put(single, prop, onFloor ? 0 : -depth);
    outlines[onFloor ? "floor" : "ground"].push(circle(prop.x, prop.y, shadowOf(prop.kind) * prop.scale));
  }
  const below = shadows(outlines.ground);
  below.position.z = -depth;
  return new Group().add(parts.mesh(), shadows(outlines.floor), below);
}

function isOn([width, length]: XY, { x, y }: PropValues): boolean {
  return Math.abs(x) <= width / 2 && Math.abs(y) <= length / 2;
}
