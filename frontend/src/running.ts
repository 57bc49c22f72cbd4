/** What runs: the program's state, the robot's, and what is set for the next run. */

import { computed, signal } from "@preact/signals";

import type { Connection } from "./connection";
import type { Ended, RunState, Scene, Telemetry, Variables } from "./messages";

const IDLE: RunState = { kind: "RunState", state: "idle" };

/** The run of the open project as the page knows it. */
export class Running {
  readonly state = signal<RunState>(IDLE);
  readonly telemetry = signal<Telemetry | null>(null);
  readonly variables = signal<Variables | null>(null);
  readonly scene = signal<Scene | null>(null);
  readonly ended = signal<Ended | null>(null);
  readonly robot = signal("");
  readonly world = signal("");
  /** Ids of blocks before which the program is held. */
  readonly breakpoints = signal<ReadonlySet<string>>(new Set());

  /** Whether a program is running, held or paused. */
  readonly active = computed(() => !["idle", "ended"].includes(this.state.value.state));
  /** The block that runs now, or before which the program is held. */
  readonly block = computed(() =>
    this.active.value ? (this.state.value.block ?? this.telemetry.value?.block ?? null) : null,
  );

  constructor(private readonly connection: Connection) {
    connection.on("Opened", (opened) => {
      this.robot.value = opened.robot;
      this.world.value = opened.world;
      this.breakpoints.value = new Set(opened.breakpoints);
      this.state.value = IDLE;
      this.variables.value = this.ended.value = this.telemetry.value = null;
    });
    connection.on("Settings", (settings) => {
      this.robot.value = settings.robot;
      this.world.value = settings.world;
      this.breakpoints.value = new Set(settings.breakpoints);
    });
    connection.on("RunState", (state) => {
      if (state.state === "starting") this.variables.value = this.ended.value = null;
      this.state.value = state;
    });
    connection.on("Telemetry", (telemetry) => (this.telemetry.value = telemetry));
    connection.on("Variables", (variables) => (this.variables.value = variables));
    connection.on("Scene", (scene) => (this.scene.value = scene));
    // A block that was tried on its own is no run of the program.
    connection.on("Ended", (ended) => (this.ended.value = ended.tried ? null : ended));
  }

  toggleBreakpoint(block: string): void {
    const blocks = new Set(this.breakpoints.value);
    if (!blocks.delete(block)) blocks.add(block);
    this.breakpoints.value = blocks;
    this.connection.send({ kind: "SetBreakpoints", blocks: [...blocks] });
  }
}
