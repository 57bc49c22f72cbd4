/** Whether and how loud the robot is heard on this computer. */

import { preferences } from "./preferences";

/** Of 100, when the user has changed nothing. */
const USUAL = 50;

/** Whether the robot is heard; in a class, the pupil has to want it. */
export function isHeard(inClass: boolean): boolean {
  const { sound, classSound } = preferences.value;
  return inClass ? classSound : sound;
}

/** The change of the preferences that lets the robot be heard or not. */
export function hear(on: boolean, inClass: boolean): { classSound: boolean } | { sound: boolean } {
  return inClass ? { classSound: on } : { sound: on };
}

/** How loud it is: 1 is the usual loudness, 2 the loudest. */
export function loudness(): number {
  return preferences.value.volume / USUAL;
}
