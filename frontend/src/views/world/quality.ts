/**
 * Lowers the quality of the picture in steps while frames are slow, and tries a better one after a pause.
 *
 * Where pixels would show, there are fewer frames instead.
 */

/** Frames between two decisions, and before one about a better quality or a picture that jerks. */
const WATCHED = 45;
const TRIED = 15;
/** ms from frame to frame that are too slow, beyond what a step waits itself. */
const SLOW = 33;
/** An average above this needs no long watching: the picture visibly jerks. */
const JERKY = 42;
/** ms by which frames of a step that waits may be late. */
const LATE = 8;
/** A longer gap is a pause, not a slow frame. */
const PAUSE = 400;
/** A pause after which a better quality is tried: the computer may have less to do. */
const REST = 3000;

/** Below this the pixels show, antialiased or not. */
const LEAST_SHARP = 0.75;

/** One step. */
export interface Quality {
  /** Whether robots reflect a room. */
  readonly reflections: boolean;
  /** Whether shadows fall on things, not only on the floor. */
  readonly shaded: boolean;
  /** Pixels of the map of shadows. */
  readonly shadows: number;
  /** Of the sharpest picture that the screen can show. */
  readonly sharpness: number;
  /** ms that it waits from frame to frame. */
  readonly pace: number;
}

/** The steps, best first. */
export const QUALITIES: readonly Quality[] = [
  { reflections: true, shaded: true, shadows: 1024, sharpness: 1, pace: 0 },
  { reflections: false, shaded: true, shadows: 1024, sharpness: 1, pace: 0 },
  { reflections: false, shaded: false, shadows: 1024, sharpness: 1, pace: 0 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 1, pace: 0 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 1, pace: 30 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 1, pace: 50 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 1, pace: 80 },
  { reflections: false, shaded: false, shadows: 512, sharpness: LEAST_SHARP, pace: 80 },
  { reflections: false, shaded: false, shadows: 512, sharpness: LEAST_SHARP, pace: 120 },
];

export class Qualities {
  private frames = 0;
  private spent = 0;
  private last = 0;
  private step: number;
  /** Whether the last frame asked for this one at once. */
  private flowed = false;
  /** Frames until the next decision. */
  private watched = WATCHED;

  /** @param best the first and best step, an index of `QUALITIES`. */
  constructor(
    private readonly best: number,
    private readonly apply: (quality: Quality) => void,
  ) {
    this.step = best;
    this.choose();
  }

  /** Note a frame at `now`, in ms; `flows` if the next one follows at once. */
  note(now: number, flows: boolean): void {
    const took = now - this.last;
    this.last = now;
    if (took > REST && !this.flowed) this.improve();
    this.flowed = flows;
    if (!flows || took > PAUSE) return;
    this.frames += 1;
    this.spent += took;
    if (this.frames < (this.jerks ? TRIED : this.watched)) return;
    if (this.spent > Math.max(SLOW, this.pace + LATE) * this.frames && this.step < QUALITIES.length - 1) {
      this.step += 1;
      this.choose();
    }
    this.decideAfter(WATCHED);
  }

  private get jerks(): boolean {
    return this.spent > Math.max(JERKY, this.pace + 2 * LATE) * this.frames;
  }

  private get pace(): number {
    return QUALITIES[this.step]?.pace ?? 0;
  }

  private improve(): void {
    if (this.step === this.best) return;
    this.step -= 1;
    this.choose();
    this.decideAfter(TRIED);
  }

  private decideAfter(frames: number): void {
    this.watched = frames;
    this.frames = this.spent = 0;
  }

  private choose(): void {
    this.apply(QUALITIES[this.step] as Quality);
  }
}
