/** The colours of the things of games, in 3D and from above. */

import type { CollectableKind } from "./description";

/** Of the plate of a switch. */
export const PLATE = "#8257e6";
export const COLLECTABLE_COLOURS: Readonly<Record<CollectableKind, string>> = {
  star: "#ffc531",
  coin: "#ffc531",
  gem: "#a855f7",
  heart: "#ef4468",
  cherry: "#e23d3d",
  battery: "#22a85b",
  key: "#ffc531",
  flag: "#2f6fed",
  bug: "#d92d2d",
  ghost: "#eef2ff",
};
