/** Tunes for named sounds and for a music player's songs. */

import effects from "../../../../src/learnblock/devices/effects.json";
import type { Tone } from "./synthesizer";

/** The tones of effects, as Hz and ms, by their names: those that robots play, too. */
const EFFECTS: Readonly<Record<string, readonly number[][]>> = effects;

/** Semitones above C, by the names of notes. */
const NOTES: Record<string, number> = {
  do: 0,
  re: 2,
  mi: 4,
  fa: 5,
  sol: 7,
  la: 9,
  si: 11,
  c: 0,
  d: 2,
  e: 4,
  f: 5,
  g: 7,
  a: 9,
  b: 11,
};
const MIDDLE_C = 261.63;
const PENTATONIC = [0, 2, 4, 7, 9, 12, 14, 16];
const NOTE_SECONDS = 0.25;
const SONG_NOTES = 32;

function pitch(halfTones: number): number {
  return MIDDLE_C * 2 ** (halfTones / 12);
}

/** A hash of a string. */
function numberOf(text: string): number {
  return [...text].reduce((sum, letter) => (sum * 31 + (letter.codePointAt(0) ?? 0)) % 65_521, 7);
}

function tune(seed: number, notes: number, seconds: number, volume: number): Tone[] {
  let state = seed;
  return Array.from({ length: notes }, (_, index) => {
    state = (state * 75 + 74) % 65_537;
    const step = PENTATONIC[state % PENTATONIC.length] ?? 0;
    return { hertz: pitch(step), seconds: seconds * 0.9, volume, delay: index * seconds };
  });
}

function effect(tones: readonly number[][], volume: number): Tone[] {
  let delay = 0;
  return tones.map(([hertz = 0, milliseconds = 0]) => {
    const tone = { hertz, seconds: milliseconds / 1000, volume, delay };
    delay += tone.seconds;
    return tone;
  });
}

/** A note by its name, such as Do, or an effect, such as coin; any other name has its own short tune. */
export function soundNamed(name: string, volume: number): Tone[] {
  const note = NOTES[name.trim().toLowerCase()];
  if (note !== undefined) return [{ hertz: pitch(note), seconds: 2 * NOTE_SECONDS, volume }];
  const tones = Object.hasOwn(EFFECTS, name) ? EFFECTS[name] : undefined;
  if (tones) return effect(tones, volume);
  return tune(numberOf(name), 4, NOTE_SECONDS / 2, volume);
}

/** A song: a generated tune, because there are no recordings. */
export function song(folder: number, number: number, volume: number): Tone[] {
  return tune(folder * 100 + number, SONG_NOTES, NOTE_SECONDS, volume);
}
