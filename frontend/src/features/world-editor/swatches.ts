/** The colours that a world offers, as one sees them. */

import { t } from "../../i18n";
import { theme } from "../../model/preferences";
import type { Swatch } from "../../ui/form/colour";
import type { Ref } from "../../views/world/plan/sorts";
import { friendly, written } from "../../views/world/scenery/colours";
import type { Colour, WorldValues } from "../../views/world/scenery/description";
import { colourOf, legible } from "../../views/world/scenery/floor-colours";
import { paletteOf, wallColour } from "../../views/world/scenery/palette";
import { defaultsOf } from "./fields";

const NAMES = ["white", "black", "grey", "red", "green", "blue", "yellow", "orange", "brown", "purple"] as const;
const WHITE = "#ffffff";

/** The colours that have a name. */
export function namedSwatches(): Swatch[] {
  return NAMES.map((name) => ({ value: name as string, shown: friendly(name), words: nameOfColour(name) }));
}

/** The colours for an object, or for the floor without one. */
export function swatchesFor(world: WorldValues, ref: Ref | null): Swatch[] {
  const named = namedSwatches();
  const palette = paletteOf(world.theme, theme.value);
  if (ref?.sort === "wall") {
    const { colour } = defaultsOf("wall") as unknown as { colour: Colour };
    const shown = wallColour(palette, { colour } as never, ref.index);
    return [{ value: written(colour), shown, words: t("page-editor-colour-theme") }, ...named];
  }
  if (ref) return named;
  // The theme colours a white floor.
  const shown = colourOf({ ...world.floor, colour: "white" }, legible(palette, world.line));
  const [white, ...others] = named;
  const asTheme = { value: "white", shown, words: t("page-editor-colour-floor") };
  return [asTheme, { value: WHITE, shown: WHITE, words: white?.words ?? "" }, ...others];
}

export function nameOfColour(colour: string): string {
  return t(`page-editor-colour-${colour}`);
}
