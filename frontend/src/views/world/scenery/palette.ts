/** The themes of worlds: the colours of everything that a world's file does not colour itself. */

import type { ThemeName } from "../../../model/preferences";
import { friendly, isDefaultWall } from "./colours";
import type { Theme, WallValues } from "./description";
import type { Line } from "./floor-paint";

/** Colours in the notation of style sheets. */
export interface Palette {
  /** From the zenith to the horizon. */
  readonly sky: readonly [string, string, string];
  readonly hasStars: boolean;
  /** Around the floor; the farther, the more it has the colour of the horizon. */
  readonly ground: string;
  readonly hills: readonly [string, string, string];
  /** The squares of the floor. */
  readonly mat: readonly [string, string];
  readonly thin: Line;
  readonly bold: Line;
  /** A shadow on a white floor. */
  readonly shade: string;
  /** The edge of the floor, or the wall around it. */
  readonly rim: string;
  readonly border: string;
  /** Walls without a colour of their own. */
  readonly walls: readonly string[];
  /** The light from above and from below, and the sun's. */
  readonly light: { readonly above: string; readonly below: string; readonly sun: string };
  readonly strength: { readonly sky: number; readonly sun: number };
}

const DAY = { above: "#ffffff", below: "#f1e9dc", sun: "#fff3dd" };
const NIGHT = { above: "#c6d0ff", below: "#4a5186", sun: "#dfe6ff" };

const PLAYGROUND: Palette = {
  sky: ["#8fd0ff", "#d5eeff", "#e4f5f4"],
  hasStars: false,
  ground: "#b4dfc2",
  hills: ["#a3d8b1", "#b5e2ba", "#95cfbf"],
  mat: ["#fdf6e6", "#f5ecd8"],
  thin: { colour: "#3c5096", opacity: 0.26 },
  bold: { colour: "#324896", opacity: 0.52 },
  shade: "#b9bcd6",
  rim: "#4f6bed",
  border: "#eef1ff",
  walls: ["#8257e6", "#6d7cff", "#38a3ff", "#12a594"],
  light: DAY,
  strength: { sky: 2.15, sun: 1.3 },
};

const EVENING: Palette = {
  sky: ["#0b1030", "#1b2458", "#2c3473"],
  hasStars: true,
  ground: "#1f2850",
  hills: ["#263064", "#2b3570", "#222b5a"],
  mat: ["#323c70", "#2b3463"],
  thin: { colour: "#b4c3ff", opacity: 0.2 },
  bold: { colour: "#b4c3ff", opacity: 0.42 },
  shade: "#8288b8",
  rim: "#7c8cff",
  border: "#3d4886",
  walls: ["#9a78f0", "#8592ff", "#4fb0ff", "#24bba9"],
  light: NIGHT,
  strength: { sky: 1.8, sun: 1.5 },
};

const THEMES: Readonly<Record<Theme, Palette>> = {
  playground: PLAYGROUND,
  city: {
    ...PLAYGROUND,
    sky: ["#7fb6e6", "#cfe3f5", "#e3ecf4"],
    ground: "#c2cad6",
    hills: ["#b3bfd0", "#c0cad8", "#a9b6c9"],
    mat: ["#eceff4", "#e2e6ee"],
    rim: "#475569",
    border: "#d5dce8",
    walls: ["#64748b", "#2563eb", "#0f766e", "#b45309"],
  },
  space: {
    ...EVENING,
    sky: ["#05060f", "#0c1026", "#1c1a45"],
    ground: "#37345c",
    hills: ["#423d70", "#4b4480", "#3a3666"],
    mat: ["#46436e", "#3e3b64"],
    rim: "#b48cff",
    border: "#55508a",
  },
  warehouse: {
    ...PLAYGROUND,
    sky: ["#d9d3c7", "#e6e1d6", "#eeeae1"],
    ground: "#cfc8ba",
    hills: ["#c4bcac", "#cbc4b5", "#bcb4a3"],
    mat: ["#eeebe4", "#e5e1d8"],
    rim: "#f0a202",
    border: "#e4ddcc",
    walls: ["#e8871e", "#c9982f", "#5f7187", "#a0643c"],
  },
  garden: {
    ...PLAYGROUND,
    ground: "#8fcf7e",
    hills: ["#7cc474", "#94d183", "#6db86e"],
    mat: ["#f0f7e3", "#e4efd3"],
    rim: "#a9713a",
    border: "#e9dcc3",
    walls: ["#b0793e", "#6bb34a", "#8f6234", "#2f8f83"],
  },
  night: EVENING,
  maze: {
    ...PLAYGROUND,
    sky: ["#b9a8ff", "#e0d8ff", "#efeaff"],
    ground: "#d5cdf5",
    hills: ["#c6bbf2", "#d3c9f6", "#b9adea"],
    mat: ["#faf6ff", "#f0eafb"],
    rim: "#7c5ce0",
    border: "#e6ddff",
  },
};

/** The themes in the evening, as far as they differ from any other place. */
const EVENINGS: Readonly<Partial<Record<Theme, Partial<Palette>>>> = {
  city: {
    sky: ["#0a1220", "#1a2738", "#2f3b4d"],
    ground: "#242f40",
    hills: ["#2b384b", "#314054", "#263243"],
    mat: ["#3d4859", "#364050"],
    rim: "#8fa3c0",
    border: "#4a586f",
    walls: ["#8496b0", "#5b8def", "#2aa79b", "#d98a3d"],
  },
  warehouse: {
    sky: ["#14110d", "#2a241c", "#3d352a"],
    hasStars: false,
    ground: "#2f2920",
    hills: ["#3a3328", "#40382c", "#332c22"],
    mat: ["#4d4840", "#45403a"],
    thin: { colour: "#ffe9c8", opacity: 0.18 },
    bold: { colour: "#ffe9c8", opacity: 0.38 },
    rim: "#f0a202",
    border: "#5f5747",
    walls: ["#e8871e", "#c9982f", "#7f93ab", "#b3764c"],
  },
  garden: {
    sky: ["#081a22", "#12323a", "#1f4a48"],
    ground: "#1d3f2c",
    hills: ["#234a35", "#285339", "#1f4230"],
    mat: ["#365241", "#2f493a"],
    rim: "#c98b50",
    border: "#4f6152",
    walls: ["#c98d52", "#7cc25c", "#a97c48", "#41aa9f"],
  },
  maze: {
    sky: ["#120a2e", "#251a55", "#3a2c78"],
    ground: "#2a2156",
    hills: ["#332868", "#3a2e74", "#2e2460"],
    mat: ["#463c7a", "#3e356e"],
    rim: "#a58bff",
    border: "#584b9c",
  },
};

/** Strong edges on plain surfaces. */
const CONTRAST: Palette = {
  ...PLAYGROUND,
  sky: ["#ffffff", "#ffffff", "#ffffff"],
  ground: "#e6e6e6",
  hills: ["#dddddd", "#e2e2e2", "#d6d6d6"],
  mat: ["#ffffff", "#ffffff"],
  thin: { colour: "#000000", opacity: 0.3 },
  bold: { colour: "#000000", opacity: 0.65 },
  rim: "#000000",
  border: "#f2f2f2",
  walls: ["#4a2a9c", "#1d3fb0", "#0b5c9c", "#006b5e"],
};

/** The colours of a world in a theme of the page. */
export function paletteOf(theme: Theme | undefined, page: ThemeName): Palette {
  if (page === "contrast") return CONTRAST;
  const name = theme ?? "playground";
  const palette = THEMES[name] ?? PLAYGROUND;
  return page === "dark" && palette.light !== NIGHT ? { ...EVENING, ...EVENINGS[name] } : palette;
}

/** The colour of a world's wall: those without one of their own take turns with the palette's. */
export function wallColour({ walls }: Palette, { colour }: WallValues, index: number): string {
  return isDefaultWall(colour) ? (walls[index % walls.length] as string) : friendly(colour);
}
