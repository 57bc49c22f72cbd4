/** The colours of a floor, for the world in 3D and for its plan. */

import { dimmed, friendly, isDark, lightnessOf } from "./colours";
import type { FloorValues, LineValues } from "./description";
import type { Squares } from "./floor-paint";
import type { Palette } from "./palette";

/** The side of a square of the grid, and the width of the floor's coloured rim, mm. */
export const CELL = 100;
export const RIM = 26;
/** A floor that is lighter has dark lines. */
const LIGHT = 0.4;
/** The light of every second square. */
const ODD = 0.92;

/** A floor at night that black lines are visible on. */
const MOONLIT = ["#949ed2", "#8a94ca"] as const;

/** The colours for a floor with lines on it. */
export function legible(palette: Palette, lines: readonly Pick<LineValues, "colour">[]): Palette {
  const [floor] = palette.mat;
  if (!isDark(floor) || !lines.some(({ colour }) => isDark(friendly(colour)))) return palette;
  return { ...palette, mat: MOONLIT };
}

/** The colour of a floor, of its lighter squares. */
export function colourOf(floor: FloorValues, palette: Palette): string {
  return coloursOf(floor, palette).even;
}

/** The colours of a floor; a white one is left to the theme. */
export function coloursOf({ colour }: FloorValues, { mat: [even, odd], thin, bold }: Palette): Squares {
  if (colour === "white") return { even, odd, thin, bold };
  const own = friendly(colour);
  const line = lightnessOf(own) > LIGHT ? "#1e2850" : "#dce4ff";
  return {
    even: own,
    odd: dimmed(own, ODD),
    thin: { colour: line, opacity: 0.16 },
    bold: { colour: line, opacity: 0.3 },
  };
}
