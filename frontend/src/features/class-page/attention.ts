/** Who needs the teacher most. */

import type { Seat } from "../../protocol/classroom";

/** Seconds after which a pupil counts as stuck, or as quiet. */
export const STUCK = 300;
export const QUIET = 180;

export type Need = "hand" | "stuck" | "error" | "quiet" | "fine" | "away";

const ORDER: readonly Need[] = ["hand", "stuck", "error", "quiet", "fine", "away"];

export function needOf(seat: Seat): Need {
  if (seat.hand) return "hand";
  if (!seat.here) return "away";
  if ((seat.stuck ?? 0) >= STUCK) return "stuck";
  if ((seat.quiet ?? 0) >= QUIET) return "quiet";
  return seat.error ? "error" : "fine";
}

/** Those who need help first, and by name among equals. */
export function byNeed(seats: Iterable<Seat>): Seat[] {
  return [...seats].sort(
    (one, other) =>
      ORDER.indexOf(needOf(one)) - ORDER.indexOf(needOf(other)) ||
      (one.name ?? "").localeCompare(other.name ?? "") ||
      one.id.localeCompare(other.id),
  );
}
