// @vitest-environment happy-dom

import { Color } from "three";
import { expect, test } from "vitest";

import { created } from "../../../src/features/world-editor/creating";
import { added } from "../../../src/features/world-editor/things";
import { theme } from "../../../src/model/preferences";
import { planOf } from "../../../src/views/world/plan/plan";
import { dimmed, friendly, isDark, lightnessOf } from "../../../src/views/world/scenery/colours";
import type { WorldValues } from "../../../src/views/world/scenery/description";
import { coloursOf } from "../../../src/views/world/scenery/floor-colours";
import { paletteOf } from "../../../src/views/world/scenery/palette";
import { emptyWorld } from "../../worlds";

const COLOURS = (["white", "black", "red", "brown", "yellow"] as const)
  .map((colour) => friendly(colour))
  .concat("rgb(12,200,3)", "#808080");

/** The colours of the floor and of its other squares in a plan. */
function floorColours(world: WorldValues): (string | null | undefined)[] {
  const [squares, floor] = planOf(world);
  return [floor, squares?.firstElementChild].map((shape) => shape?.getAttribute("fill"));
}

test.each(["playground", "night", "garden"] as const)(
  "the floor of a plan in a %s has the world's colours",
  (place) => {
    const { even, odd } = coloursOf(emptyWorld().floor, paletteOf(place, theme.value));
    expect(floorColours({ ...emptyWorld(), theme: place })).toEqual([even, odd]);
  },
);

test("a floor with a colour of its own has it in the plan, too", () => {
  const world = { ...emptyWorld(), floor: { ...emptyWorld().floor, colour: "red" as const } };
  expect(floorColours(world)[0]).toBe(friendly("red"));
});

test.each(["zone", "switch", "gate", "door", "mover", "collectable"] as const)("a %s is in the plan", (sort) => {
  const [world] = added(emptyWorld(), sort, created(emptyWorld(), sort, [100, 50]));
  expect(planOf(world).length).toBeGreaterThan(planOf(emptyWorld()).length);
});

test("the lightness and the dimming of colours are those of three, which the plan does without", () => {
  for (const colour of COLOURS) {
    const three = new Color(colour);
    expect(lightnessOf(colour)).toBeCloseTo(three.getHSL({ h: 0, s: 0, l: 0 }).l, 4);
    expect(dimmed(colour, 0.92)).toBe(three.multiplyScalar(0.92).getStyle());
  }
  expect(COLOURS.filter(isDark)).toContain(friendly("black"));
});
