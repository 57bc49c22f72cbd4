/** The user's preferences, kept by the browser: language, theme, sizes. */

import { computed, effect, signal } from "@preact/signals";

import type { View } from "../protocol/messages";
import { media } from "../ui/media";
import { inBrowser } from "../ui/storage";
import { STAGES, type Stage } from "./stages";

export type ThemeName = "light" | "dark" | "contrast";

/** The themes to choose from. */
export const THEMES: readonly (ThemeName | "system")[] = ["system", "light", "dark", "contrast"];

export { STAGES, type Stage };

/** Which regions of the page are shown, and their sizes. */
export interface Layout {
  /** Whether several views of the program are shown side by side. */
  readonly split: boolean;
  /** The views that are shown side by side. */
  readonly views: readonly View[];
  /** The only view otherwise. */
  readonly view: View;
  /** Whether the palette stays open beside the program. */
  readonly pinned: boolean;
  /** Whether the output is shown below the world. */
  readonly panel: boolean;
  /** Sizes relative to one another. */
  readonly weights: Readonly<Record<View, number>>;
  /** Sizes of the views' column and of the world's. */
  readonly columns: readonly [number, number];
  /** Sizes of the world and of the panel below it. */
  readonly rows: readonly [number, number];
  readonly camera: boolean;
  readonly drive: boolean;
}

export interface Preferences {
  readonly language: string;
  readonly theme: ThemeName | "system";
  readonly sound: boolean;
  /** The same in a class, where many sit in one room. */
  readonly classSound: boolean;
  /** How loud the robot is, 0 to 100. */
  readonly volume: number;
  /** Whether sounds report distances ahead and collisions. */
  readonly audible: boolean;
  /** Whether the world celebrates goals that the robot reaches. */
  readonly celebrate: boolean;
  readonly tourDone: boolean;
  readonly stage: Stage;
  /** The user's robot, for new projects and examples; empty for the usual one. */
  readonly robot: string;
  /** The world of the last new project; empty for the usual one. */
  readonly world: string;
  /** The worlds chosen last, the latest first. */
  readonly recentWorlds: readonly string[];
  readonly layout: Layout;
}

const STORED = inBrowser("learnblock.preferences");
const LAYOUT: Layout = {
  split: false,
  views: ["blocks", "blocktext"],
  view: "blocks",
  pinned: true,
  panel: false,
  weights: { blocks: 60, blocktext: 40, python: 40 },
  columns: [60, 40],
  rows: [66, 34],
  camera: false,
  drive: false,
};
const DEFAULTS: Preferences = {
  language: navigator.language.slice(0, 2),
  theme: "system",
  sound: true,
  classSound: false,
  volume: 50,
  audible: false,
  celebrate: true,
  tourDone: false,
  stage: "starter",
  robot: "",
  world: "",
  recentWorlds: [],
  layout: LAYOUT,
};

function load(): Preferences {
  const kept = (STORED.readValue() ?? {}) as Partial<Preferences>;
  return { ...DEFAULTS, ...kept, layout: { ...LAYOUT, ...kept.layout } };
}

export const preferences = signal<Preferences>(load());

export function prefer(change: Partial<Preferences>): void {
  preferences.value = { ...preferences.value, ...change };
}

export function arrange(change: Partial<Layout>): void {
  prefer({ layout: { ...preferences.value.layout, ...change } });
}

/** What each stage shows at first. */
const FIRST_SHOWN: Readonly<Record<Stage, Partial<Layout>>> = {
  starter: { split: false, view: "blocks", panel: false },
  explorer: { split: false, view: "blocks", panel: false },
  // At 1366 px the first line of a Python program is whole beside the blocks.
  coder: {
    split: true,
    views: ["blocks", "python"],
    view: "python",
    panel: true,
    weights: { blocks: 46, blocktext: 40, python: 54 },
  },
};

export function chooseStage(stage: Stage): void {
  prefer({ stage });
  arrange(FIRST_SHOWN[stage]);
}

/** Whether the buttons of the debugger are shown. */
export const showsDebugger = computed(() => preferences.value.stage !== "starter");

export const preferredLanguage = computed(() => preferences.value.language);

const dark = media("(prefers-color-scheme: dark)");
const contrast = media("(prefers-contrast: more)");

/** The theme in use: the system's if the user prefers that. */
export const theme = computed<ThemeName>(() => {
  const wish = preferences.value.theme;
  if (wish !== "system") return wish;
  if (contrast.value) return "contrast";
  return dark.value ? "dark" : "light";
});

effect(() => STORED.writeValue(preferences.value));
