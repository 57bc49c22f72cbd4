/** A film of a canvas, in the first format that the browser can record. */

const FORMATS = [
  { type: "video/webm", ending: "webm" },
  { type: "video/mp4", ending: "mp4" },
] as const;

export type Format = (typeof FORMATS)[number];

/** The format of this browser's films; undefined if it can't record any. */
export function filmFormat(): Format | undefined {
  if (typeof MediaRecorder === "undefined") return undefined;
  return FORMATS.find(({ type }) => MediaRecorder.isTypeSupported(type));
}

/** A recording that goes on until it is ended or dropped. */
export class Film {
  private readonly recorder: MediaRecorder;
  private readonly parts: Blob[] = [];
  private readonly frames: number;
  private readonly timeout: number;

  /**
   * @param draw draws the next frame into the canvas.
   * @param rate of frames in a second.
   * @param longest the longest film, ms.
   * @param done is called once, with the film, or with null if it was dropped.
   */
  constructor(
    canvas: HTMLCanvasElement,
    format: Format,
    { draw, rate, longest }: { draw: () => void; rate: number; longest: number },
    private readonly done: (film: Blob | null) => void,
  ) {
    this.recorder = new MediaRecorder(canvas.captureStream(rate), { mimeType: format.type });
    this.recorder.ondataavailable = ({ data }) => this.parts.push(data);
    this.recorder.onstop = () => this.finish(new Blob(this.parts));
    this.recorder.start();
    this.frames = window.setInterval(draw, 1000 / rate);
    this.timeout = window.setTimeout(() => this.end(), longest);
  }

  end(): void {
    if (this.recorder.state === "recording") this.recorder.stop();
  }

  /** Stop without a film. */
  drop(): void {
    this.recorder.onstop = null;
    this.end();
    this.finish(null);
  }

  private finish(film: Blob | null): void {
    window.clearInterval(this.frames);
    window.clearTimeout(this.timeout);
    this.done(film);
  }
}
