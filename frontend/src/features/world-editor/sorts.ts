/** The sorts of objects in a world. */

/** In the order in which they are painted and reached by Tab. */
export const SORTS = [
  "follow",
  "line",
  "reach",
  "visit",
  "tour",
  "stop",
  "show",
  "avoid",
  "start",
  "wall",
  "box",
  "cylinder",
  "prop",
  "tag",
  "face",
  "light",
] as const;
export type Sort = (typeof SORTS)[number];

/** The values of one object of any sort. */
export type Thing = Readonly<Record<string, unknown>>;
