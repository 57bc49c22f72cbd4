/** Plays tones on the computer's loudspeaker. */

export interface Tone {
  readonly hertz: number;
  readonly seconds: number;
  /** 0 to 1. */
  readonly volume: number;
  /** Seconds from now. */
  readonly delay?: number;
}

/** The maximum number of tones at once: a program at full speed could play thousands. */
const MOST_AT_ONCE = 48;
const LONGEST_SECONDS = 10;
/** The fade time of a tone in seconds, which avoids clicks. */
const FADE = 0.01;
const GESTURES = ["pointerdown", "keydown"] as const;

/** Plays tones after the first user action: browsers allow no sound before. */
export class Synthesizer {
  private context: AudioContext | null = null;
  private readonly playing = new Set<OscillatorNode>();
  private readonly wake = () => {
    this.context ??= new AudioContext();
    if (this.context.state === "suspended") void this.context.resume();
  };

  constructor() {
    for (const gesture of GESTURES) addEventListener(gesture, this.wake, { capture: true, passive: true });
  }

  play({ hertz, seconds, volume, delay = 0 }: Tone): void {
    const context = this.context;
    const audible = hertz >= 20 && hertz <= 20_000 && seconds > 0 && volume > 0;
    if (!context || !audible || this.playing.size >= MOST_AT_ONCE) return;
    const start = context.currentTime + delay;
    const end = start + Math.min(seconds, LONGEST_SECONDS);
    const oscillator = new OscillatorNode(context, { type: "triangle", frequency: hertz });
    oscillator.connect(swelling(context, volume, start, end)).connect(context.destination);
    oscillator.onended = () => this.playing.delete(oscillator);
    this.playing.add(oscillator);
    oscillator.start(start);
    oscillator.stop(end + FADE);
  }

  silence(): void {
    for (const oscillator of this.playing) oscillator.stop();
    this.playing.clear();
  }

  destroy(): void {
    for (const gesture of GESTURES) removeEventListener(gesture, this.wake, { capture: true });
    this.silence();
    void this.context?.close();
  }
}

function swelling(context: AudioContext, volume: number, start: number, end: number): GainNode {
  const gain = new GainNode(context, { gain: 0 });
  gain.gain.setValueAtTime(0, start);
  gain.gain.linearRampToValueAtTime(volume, start + FADE);
  gain.gain.setValueAtTime(volume, Math.max(start + FADE, end - FADE));
  gain.gain.linearRampToValueAtTime(0, end + FADE);
  return gain;
}
