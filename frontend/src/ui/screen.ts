/** The size class of the screen. */

import { computed } from "@preact/signals";

import { media } from "./media";

/**
 * `wide` has the program beside the world, `medium` below it; `narrow` is a phone, which also has less
 * room for buttons.
 */
export type Room = "wide" | "medium" | "narrow";

export const isNarrow = media("(max-width: 699px)");
/** A phone on its side. Styles for phones have the same condition. */
const isLow = media("(max-width: 999px) and (max-height: 479px)");
const upright = media("(max-width: 1199px) and (orientation: portrait)");

export const room = computed<Room>(() => {
  if (isNarrow.value || isLow.value) return "narrow";
  return upright.value ? "medium" : "wide";
});
