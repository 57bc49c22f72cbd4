/** How much room there is. */

import { computed } from "@preact/signals";

import { media } from "../preferences";

/** `wide` shows several views of the program, `medium` one beside the world, `narrow` one thing. */
export type Room = "wide" | "medium" | "narrow";

const wide = media("(min-width: 1200px)");
const medium = media("(min-width: 800px)");

export const room = computed<Room>(() => {
  if (wide.value) return "wide";
  return medium.value ? "medium" : "narrow";
});
