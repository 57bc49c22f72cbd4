/** The drawing on the floor of the world: the strokes of the robots' pens. */

import { signal } from "@preact/signals";
import type { Drawing as News } from "../protocol/messages";

export interface Stroke {
  readonly color: readonly [number, number, number];
  /** mm. */
  readonly width: number;
  /** Places on the floor, mm; points are only added. */
  readonly points: [number, number][];
}

/** Add to strokes what they have gained; return them. */
export function addParts(strokes: Stroke[], parts: NonNullable<News["parts"]>): Stroke[] {
  for (const { stroke, color, width, points } of parts) {
    strokes[stroke] ??= { color, width, points: [] };
    strokes[stroke].points.push(...points);
  }
  return strokes;
}

export class Drawing {
  /** A new list whenever everything was erased. */
  strokes: Stroke[] = [];
  /** Grows with every change. */
  readonly changes = signal(0);

  receive({ fresh, parts = [] }: News): void {
    if (fresh) this.strokes = [];
    addParts(this.strokes, parts);
    this.changes.value++;
  }
}
