/** What a user likes, kept by the browser: language, theme, sizes. */

import { effect, signal } from "@preact/signals";

export type ThemeName = "light" | "dark" | "contrast";
export interface Preferences {
  readonly language: string;
  readonly theme: ThemeName | "system";
  readonly sound: boolean;
  readonly tourDone: boolean;
}

const KEY = "learnblock.preferences";
const DEFAULTS: Preferences = {
  language: navigator.language.slice(0, 2),
  theme: "system",
  sound: true,
  tourDone: false,
};

function load(): Preferences {
  try {
    return { ...DEFAULTS, ...(JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Preferences>) };
  } catch {
    // Somebody else's value, or a browser that keeps nothing: the defaults serve.
    return DEFAULTS;
  }
}

export const preferences = signal<Preferences>(load());

export function prefer(change: Partial<Preferences>): void {
  preferences.value = { ...preferences.value, ...change };
}

effect(() => localStorage.setItem(KEY, JSON.stringify(preferences.value)));
