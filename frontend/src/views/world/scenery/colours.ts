/** The colours that worlds may name; the same values as in `learnblock.simulator.colours`. */

import type { Colour } from "./description";

const NAMED: Readonly<Record<string, readonly [number, number, number]>> = {
  white: [240, 240, 240],
  black: [20, 20, 20],
  grey: [150, 150, 150],
  red: [215, 25, 25],
  green: [40, 150, 60],
  blue: [25, 70, 215],
  yellow: [240, 205, 40],
  orange: [240, 135, 30],
  brown: [140, 95, 60],
  purple: [130, 60, 160],
};

/** Its red, green and blue, 0 to 255. */
export function rgb(colour: Colour): readonly [number, number, number] {
  return typeof colour === "string" ? (NAMED[colour] ?? [150, 150, 150]) : colour;
}

/** The value of a field for a colour: its name, or "#rrggbb". */
export function written(colour: Colour): string {
  if (typeof colour === "string") return colour;
  return `#${rgb(colour)
    .map((level) => level.toString(16).padStart(2, "0"))
    .join("")}`;
}

/** The colour that a field's value means. */
export function colourIn(value: string): Colour {
  if (!value.startsWith("#")) return value as Colour;
  return [1, 3, 5].map((start) => Number.parseInt(value.slice(start, start + 2), 16)) as unknown as Colour;
}

/** In the notation of style sheets and three.js. */
export function css(colour: Colour): string {
  return `rgb(${rgb(colour).join(",")})`;
}

/** How the world in 3D shows the named colours: the same hues, in the shades of the page. */
const FRIENDLY: Readonly<Record<string, string>> = {
  white: "#f8f9fc",
  black: "#171c2b",
  grey: "#a3adbf",
  red: "#ef4444",
  green: "#2fae5b",
  blue: "#2f7bff",
  yellow: "#ffc933",
  orange: "#ff8a1f",
  brown: "#b8793f",
  purple: "#8257e6",
};

/** A colour for the world in 3D; a world's own red, green and blue stay. */
export function friendly(colour: Colour): string {
  return (typeof colour === "string" && FRIENDLY[colour]) || css(colour);
}

/** Colours darker than this are dark. */
const DARK = 0.35;

export function isDark(colour: string): boolean {
  return lightnessOf(colour) < DARK;
}

/** The lightness of a colour in the notation of style sheets, 0 to 1: of its light, not of its numbers. */
export function lightnessOf(colour: string): number {
  const light = lightOf(colour);
  return (Math.max(...light) + Math.min(...light)) / 2;
}

/** A colour with a share of its light. */
export function dimmed(colour: string, share: number): string {
  const levels = lightOf(colour).map((light) => Math.round(255 * encoded(light * share)));
  return `rgb(${levels.join(",")})`;
}

/** Its red, green and blue light, 0 to 1. */
function lightOf(colour: string): number[] {
  const pairs = colour.startsWith("#") ? (colour.match(/[\da-f]{2}/gi) ?? []) : [];
  const levels = pairs.length
    ? pairs.map((pair) => Number.parseInt(pair, 16))
    : (colour.match(/\d+/g) ?? []).map(Number);
  return levels.map((level) => decoded(level / 255));
}

function decoded(level: number): number {
  return level <= 0.04045 ? level / 12.92 : ((level + 0.055) / 1.055) ** 2.4;
}

function encoded(light: number): number {
  return light <= 0.0031308 ? light * 12.92 : 1.055 * light ** (1 / 2.4) - 0.055;
}

/** The colour of walls in the simulator that have none of their own. */
const WALL: readonly [number, number, number] = [205, 200, 185];

export function isDefaultWall(colour: Colour): boolean {
  return rgb(colour).join() === WALL.join();
}

/** The page's marks in a world: legible on light and dark floors. */
export const MARKS = {
  open: "#f08c00",
  reached: "#1c9c4a",
  failed: "#d23b3b",
  start: "#2f6fed",
  trail: "#f97316",
  beam: "#12b5cb",
  hit: "#ef2d3c",
  handle: "#2f6fed",
  star: "#ffc933",
} as const;
