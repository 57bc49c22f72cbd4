/** Places that a run has missed, and by how much. */

import { type Phrase, say } from "../i18n";

type XY = [number, number];

/** Lengths in mm. */
export interface MissedPlace {
  readonly place: XY;
  /** Where the robot came nearest. */
  readonly nearest: XY;
  /** By how much. */
  readonly words: string;
}

/** @param reason what was missed, with the gap alone as one of its values if it has a place. */
export function missedPlace(reason: Phrase, place: XY, nearest: XY): MissedPlace {
  const { gap } = reason.values ?? {};
  return { place, nearest, words: say(isPhrase(gap) ? gap : reason) };
}

function isPhrase(value: unknown): value is Phrase {
  return typeof value === "object" && value !== null && "code" in value;
}
