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

/** In the notation of style sheets and three.js. */
export function css(colour: Colour): string {
  return `rgb(${rgb(colour).join(",")})`;
}

/** The page's marks in a world: legible on light and dark floors. */
export const MARKS = {
  open: "#2f6fed",
  reached: "#1c9c4a",
  failed: "#d23b3b",
  start: "#7a8699",
  trail: "#ff8a1f",
  beam: "#e0457b",
  handle: "#2f6fed",
} as const;
