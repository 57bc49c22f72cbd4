/** The size class of the screen. */

import { computed } from "@preact/signals";

import { media } from "./media";

/** `wide` shows several views of the program, `medium` one beside the world, `narrow` one region. */
export type Room = "wide" | "medium" | "narrow";

const wide = media("(min-width: 1200px)");
const medium = media("(min-width: 800px)");

export const room = computed<Room>(() => {
  if (wide.value) return "wide";
  return medium.value ? "medium" : "narrow";
});
