/** What a user likes, kept by the browser: language, theme, sizes. */

import { computed, effect, signal } from "@preact/signals";

import type { View } from "./messages";

export type ThemeName = "light" | "dark" | "contrast";

/** Which parts of the page are shown, and how large. */
export interface Layout {
  /** The program's views where there is room for several. */
  readonly views: readonly View[];
  /** The one where there is room for one. */
  readonly view: View;
  /** Sizes relative to one another. */
  readonly weights: Readonly<Record<View, number>>;
  /** Sizes of the views' column and of the world's. */
  readonly columns: readonly [number, number];
  /** Sizes of the world and of what stands below it. */
  readonly rows: readonly [number, number];
  readonly camera: boolean;
  readonly drive: boolean;
}

export interface Preferences {
  readonly language: string;
  readonly theme: ThemeName | "system";
  readonly sound: boolean;
  /** Whether the robot's state can be heard: distances ahead, collisions. */
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
    // Somebody else's value, or a browser that keeps nothing: the defaults serve.
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

/** A media query as a signal. */
export function media(query: string) {
  const list = matchMedia(query);
  const matches = signal(list.matches);
  list.addEventListener("change", () => (matches.value = list.matches));
  return matches;
}

const dark = media("(prefers-color-scheme: dark)");
const contrast = media("(prefers-contrast: more)");

/** The theme in use: the system's own where the user wants that. */
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
    // A browser that keeps nothing: what the user likes lasts as long as the page.
  }
});
