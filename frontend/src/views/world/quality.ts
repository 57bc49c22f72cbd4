/** Lowers the quality of the picture in steps while frames are slow, and tries a better one after a pause. */

/** Frames between two decisions, and before one about a better quality or a picture that jerks. */
const WATCHED = 45;
const TRIED = 15;
/** ms from frame to frame that are too slow. */
const SLOW = 33;
/** An average above this needs no long watching: the picture visibly jerks. */
const JERKY = 42;
/** A longer gap is a pause, not a slow frame. */
const PAUSE = 400;
/** A pause after which a better quality is tried: the computer may have less to do. */
const REST = 3000;

/** The steps, best first. */
export interface Quality {
  /** Whether robots reflect a room. */
  readonly reflections: boolean;
  /** Whether shadows fall on things, not only on the floor. */
  readonly shaded: boolean;
  /** Pixels of the map of shadows. */
  readonly shadows: number;
  /** Of the sharpest picture that the screen can show. */
  readonly sharpness: number;
}

export const QUALITIES: readonly Quality[] = [
  { reflections: true, shaded: true, shadows: 1024, sharpness: 1 },
  { reflections: false, shaded: true, shadows: 1024, sharpness: 1 },
  { reflections: false, shaded: false, shadows: 1024, sharpness: 1 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 1 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 0.75 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 0.6 },
  { reflections: false, shaded: false, shadows: 512, sharpness: 0.5 },
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
    if (this.spent / this.frames > SLOW && this.step < QUALITIES.length - 1) {
      this.step += 1;
      this.choose();
    }
    this.decideAfter(WATCHED);
  }

  private get jerks(): boolean {
    return this.spent > JERKY * this.frames;
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
