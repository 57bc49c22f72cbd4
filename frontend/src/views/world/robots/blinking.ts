/** When robots close their eyes for a moment. */

/** ms from one closing to the next, in turn, so that it doesn't look like a clock. */
const PAUSES = [3700, 5200, 2900, 4600] as const;
const LASTS = 130;
const ROUND = PAUSES.reduce((sum, pause) => sum + pause, 0);

/** Whether eyes are closed at `now`, ms. */
export function isBlinking(now: number): boolean {
  let left = now % ROUND;
  for (const pause of PAUSES) {
    if (left < pause) return left >= pause - LASTS;
    left -= pause;
  }
  return false;
}
