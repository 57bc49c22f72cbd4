/** The floor of a plan, in the colours in which the world in 3D shows it. */

import { theme } from "../../../model/preferences";
import type { WorldValues } from "../scenery/description";
import { CELL, coloursOf, legible, RIM } from "../scenery/floor-colours";
import { paletteOf } from "../scenery/palette";
import { svg } from "./svg";

export function groundOf({ floor, line, theme: place }: WorldValues): SVGElement[] {
  const [width, height] = floor.size;
  const area = { x: -width / 2, y: -height / 2, width, height };
  const palette = paletteOf(place, theme.value);
  const { even, odd } = coloursOf(floor, legible(palette, line));
  // Plans beside each other with the same id have the same squares.
  const id = `plan-squares-${odd.replaceAll(/\W/g, "-")}`;
  const squares = svg(
    "pattern",
    { id, width: 2 * CELL, height: 2 * CELL, patternUnits: "userSpaceOnUse" },
    svg("path", { d: `M0 0 h${CELL} v${2 * CELL} h${CELL} v-${CELL} h-${2 * CELL} z`, fill: odd }),
  );
  const edge =
    floor.border > 0
      ? svg("rect", { ...area, class: "border", stroke: palette.rim, "stroke-width": RIM })
      : svg("rect", { ...area, class: "edge" });
  return [squares, svg("rect", { ...area, fill: even }), svg("rect", { ...area, fill: `url(#${id})` }), edge];
}
