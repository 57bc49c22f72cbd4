/** How fast the simulated world really runs, which may be less than the chosen speed. */

/** Seconds over which it is measured. */
const WINDOW = 2;
/** Less than this share of the chosen speed is shown. */
const CLEARLY_LESS = 0.8;

interface Mark {
  readonly time: number;
  readonly now: number;
}

/** Measures the world's time against the computer's. */
export class Pace {
  private marks: readonly Mark[] = [];

  /** Forget what was measured, because the world stood still or began again. */
  reset(): void {
    this.marks = [];
  }

  /** Add a time of the world, in seconds, seen now; return times real time, or null if it is too early to say. */
  add(time: number, now: number): number | null {
    const last = this.marks.at(-1);
    if (last && time < last.time) this.reset();
    this.marks = [...this.marks.filter((mark) => now - mark.now <= WINDOW), { time, now }];
    const first = this.marks[0]!;
    return now - first.now < WINDOW / 2 ? null : (time - first.time) / (now - first.now);
  }
}

/** The speed to tell beside the chosen one: it is clearly less, or as fast as the computer can was chosen. */
export function shownSpeed(reached: number | null, chosen: number | null): number | null {
  if (reached === null || (chosen !== null && reached >= CLEARLY_LESS * chosen)) return null;
  return reached < 10 ? Math.round(10 * reached) / 10 : Math.round(reached);
}
