/** The floor under the plan, in the colours in which the world shows it. */

import { theme } from "../../model/preferences";
import type { WorldValues } from "../../views/world/scenery/description";
import { coloursOf, legible, RIM } from "../../views/world/scenery/mat";
import { paletteOf } from "../../views/world/scenery/palette";
import { svg } from "./svg";

/** The side of a square of the grid, mm. */
const CELL = 100;

export function groundOf({ floor, line, theme: place }: WorldValues): SVGElement[] {
  const [width, height] = floor.size;
  const area = { x: -width / 2, y: -height / 2, width, height };
  const palette = paletteOf(place, theme.value);
  const { even, odd } = coloursOf(floor, legible(palette, line));
  const squares = svg(
    "pattern",
    { id: "plan-squares", width: 2 * CELL, height: 2 * CELL, patternUnits: "userSpaceOnUse" },
    svg("path", { d: `M0 0 h${CELL} v${2 * CELL} h${CELL} v-${CELL} h-${2 * CELL} z`, fill: odd }),
  );
  const edge =
    floor.border > 0
      ? svg("rect", { ...area, class: "border", stroke: palette.rim, "stroke-width": RIM })
      : svg("rect", { ...area, class: "edge" });
  return [
    squares,
    svg("rect", { ...area, fill: even }),
    svg("rect", { ...area, fill: "url(#plan-squares)" }),
    edge,
    svg("path", { d: "M0 -60 V60 M-60 0 H60", class: "axes" }),
  ];
}
