/** A hand that shakes and tilts a simulated robot, for its accelerometer. */

import { computed, effect, signal } from "@preact/signals";

import type { Context } from "../../model/context";
import type { HandleRobot } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Tool } from "../../ui/tool";

type How = HandleRobot["how"];

/** The sides to which the robot can be tilted, with their keys: as on a keypad of digits. */
const SIDES = { front: "8", back: "2", left: "4", right: "6" } as const;
const SHAKE_KEY = "5";

export class Hand {
  readonly tools: readonly Tool[];
  private readonly tilt = signal<How>("level");
  private readonly cleanup: Cleanup;

  constructor(private readonly context: Context) {
    const { running } = context;
    const feels = computed(() => !running.scene.value?.real && hasAccelerometer(running.scene.value?.robots[0]?.[1]));
    const sides = Object.entries(SIDES) as [keyof typeof SIDES, string][];
    this.tools = [
      { name: "shake", key: SHAKE_KEY, enabled: feels, act: () => this.send("shake") },
      ...sides.map(([side, key]) => ({
        name: side,
        key,
        enabled: feels,
        pressed: computed(() => this.tilt.value === side),
        act: () => this.tiltTo(side),
      })),
    ];
    this.cleanup = new Cleanup(
      // In another world or a new run, the robot is level again.
      effect(() => {
        if (running.scene.value) this.tilt.value = "level";
      }),
      effect(() => {
        if (running.state.value.state === "starting") this.tilt.value = "level";
      }),
    );
  }

  destroy(): void {
    this.cleanup.dispose();
  }

  /** The side that is chosen already is let go. */
  private tiltTo(side: How): void {
    this.tilt.value = this.tilt.value === side ? "level" : side;
    this.send(this.tilt.value);
  }

  private send(how: How): void {
    this.context.connection.send({ kind: "HandleRobot", how });
  }
}

function hasAccelerometer(values: unknown): boolean {
  return values instanceof Object && "accelerometer" in values && values.accelerometer !== null;
}
