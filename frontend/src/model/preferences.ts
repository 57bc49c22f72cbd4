/** The user's preferences, kept by the browser: language, theme, sizes. */

import { computed, effect, signal } from "@preact/signals";

import type { View } from "../protocol/messages";
import { media } from "../ui/media";

export type ThemeName = "light" | "dark" | "contrast";

/** The themes to choose from. */
export const THEMES: readonly (ThemeName | "system")[] = ["system", "light", "dark", "contrast"];

/** Which regions of the page are shown, and their sizes. */
export interface Layout {
  /** The program's views on a wide screen. */
  readonly views: readonly View[];
  /** The view on other screens. */
  readonly view: View;
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
  /** Whether sounds report distances ahead and collisions. */
  readonly audible: boolean;
  readonly tourDone: boolean;
  readonly layout: Layout;
}

const KEY = "learnblock.preferences";
const LAYOUT: Layout = {
  views: ["blocks", "blocktext"],
  view: "blocks",
  weights: { blocks: 60, blocktext: 40, python: 40 },
  columns: [62, 38],
  rows: [58, 42],
  camera: false,
  drive: false,
};
const DEFAULTS: Preferences = {
  language: navigator.language.slice(0, 2),
  theme: "system",
  sound: true,
  audible: false,
  tourDone: false,
  layout: LAYOUT,
};

function load(): Preferences {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Preferences>;
    return { ...DEFAULTS, ...kept, layout: { ...LAYOUT, ...kept.layout } };
  } catch {
    // Storage is disabled or contains another program's value: use the defaults.
    return DEFAULTS;
  }
}

export const preferences = signal<Preferences>(load());

export function prefer(change: Partial<Preferences>): void {
  preferences.value = { ...preferences.value, ...change };
}

export function arrange(change: Partial<Layout>): void {
  prefer({ layout: { ...preferences.value.layout, ...change } });
}

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

effect(() => {
  const kept = JSON.stringify(preferences.value);
  try {
    localStorage.setItem(KEY, kept);
  } catch {
    // Storage is disabled: the preferences last until the page is closed.
  }
});
