/** The address of a hand-in on the page of all hand-ins. */

export interface HandInAddress {
  /** The pupil's id. */
  readonly pupil: string;
  readonly lesson: string;
  readonly step: number;
}

/** The link to a hand-in, relative to the wall. */
export function handInPage({ pupil, lesson, step }: HandInAddress): string {
  return `hand-ins#${new URLSearchParams({ pupil, lesson, step: String(step) })}`;
}

/** The hand-in of a page's address; null if it names none. */
export function handInAt(hash: string): HandInAddress | null {
  const named = new URLSearchParams(hash.replace(/^#/, ""));
  const [pupil, lesson, step] = [named.get("pupil"), named.get("lesson"), Number(named.get("step"))];
  return pupil && lesson && step ? { pupil, lesson, step } : null;
}
