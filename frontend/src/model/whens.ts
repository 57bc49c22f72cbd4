/** The types of the blocks of events, as on the server. */

import { GAME_HATS } from "./games";

/** Those whose condition is part of their sentence, which is that of a skill. */
export const READY_HATS = [
  "lb_when_is_key_pressed",
  "lb_when_is_bumped",
  "lb_when_is_front_obstacle",
  "lb_when_received",
  ...GAME_HATS,
];

export const WHENS = ["lb_when", ...READY_HATS];
