/** Where the twin of a real robot would have been, while the user looks back at its run. */

import { computed, signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { Predicted, Robot } from "../protocol/messages";
import { RUN_COLOURS, type Way } from "./kept-runs";
import type { Running } from "./running";

/** Of the twin's way and of the real one, which is thinner and on top. */
export const GHOST_COLOURS = RUN_COLOURS;

export class Ghost {
  /** What the server has predicted; null without a real robot's run. */
  readonly predicted = signal<Predicted | null>(null);
  /** What is shown of it: only while the user looks back. */
  readonly shown = computed(() => {
    const predicted = this.predicted.value;
    return this.running.past.value && predicted?.way?.length ? predicted : null;
  });
  /** The twin's way and the robot's; none while nothing is shown. */
  readonly ways = computed(() => (this.shown.value ? this.waysOf(this.shown.value) : []));
  /** The twin at the moment that is shown; null without one. */
  readonly robot = computed(() => (this.shown.value ? this.at(this.shown.value) : null));

  constructor(
    connection: Connection,
    private readonly running: Running,
  ) {
    connection.on("Timeline", ({ end, exact }) => {
      this.predicted.value = null;
      if (end > 0 && exact === false) connection.send({ kind: "ReadPrediction" });
    });
    connection.on("Predicted", (predicted) => (this.predicted.value = predicted));
  }

  private waysOf({ way = [], parted = null }: Predicted): Way[] {
    const real = this.running.timeline.value?.way ?? [];
    return [
      { points: way.map(([time, x, y]) => [time, x, y] as const), colour: GHOST_COLOURS[0], parted: null },
      { points: real, colour: GHOST_COLOURS[1], parted: placeAt(real, parted) },
    ];
  }

  private at({ way = [] }: Predicted): Robot | null {
    const time = this.running.past.value?.time ?? 0;
    const [, x, y, heading] = way.findLast(([at]) => at <= time) ?? way[0] ?? [];
    return x === undefined || y === undefined || heading === undefined ? null : { name: "", x, y, heading };
  }
}

function placeAt(way: Way["points"], time: number | null): Way["parted"] {
  const point = time === null ? undefined : (way.find(([at]) => at >= time) ?? way.at(-1));
  return point ? [point[1], point[2]] : null;
}
