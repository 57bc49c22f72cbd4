import { Color } from "three";
import { expect, it } from "vitest";
import type { Theme } from "../../../src/views/world/scenery/description";
import { paletteOf } from "../../../src/views/world/scenery/palette";

const PLACES: readonly Theme[] = ["playground", "city", "space", "warehouse", "garden", "maze"];

it("every theme has colours of its own, by day and in the evening", () => {
  for (const page of ["light", "dark"] as const) {
    const grounds = PLACES.map((theme) => paletteOf(theme, page).ground);
    expect(new Set(grounds).size).toBe(PLACES.length);
  }
});

it("every theme is dark on a dark page", () => {
  const lightness = (colour: string) => new Color(colour).getHSL({ h: 0, s: 0, l: 0 }).l;
  for (const theme of [...PLACES, "night"] as const) {
    const { mat, ground, sky } = paletteOf(theme, "dark");
    expect(Math.max(...[...mat, ground, ...sky].map(lightness))).toBeLessThan(0.35);
  }
});
