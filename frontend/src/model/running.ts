/** The current run: the state of program and robot, and the settings for the next run. */

import { computed, signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { Ended, RobotLink, RunningLine, RunState, Scene, Telemetry, Variables } from "../protocol/messages";

const IDLE: RunState = { kind: "RunState", state: "idle" };

/** The run of the open project. */
export class Running {
  readonly state = signal<RunState>(IDLE);
  readonly telemetry = signal<Telemetry | null>(null);
  /** The link to the robot; null until the server has reported it. */
  readonly link = signal<RobotLink | null>(null);
  readonly line = signal<RunningLine | null>(null);
  readonly variables = signal<Variables | null>(null);
  readonly scene = signal<Scene | null>(null);
  readonly ended = signal<Ended | null>(null);
  readonly robot = signal("");
  readonly world = signal("");
  /** Ids of blocks with a breakpoint. */
  readonly breakpoints = signal<ReadonlySet<string>>(new Set());

  /** Whether a program is running or paused. */
  readonly active = computed(() => !["idle", "ended"].includes(this.state.value.state));
  /** The block that is running, or at which the program is paused. */
  readonly block = computed(() =>
    this.active.value ? (this.state.value.block ?? this.line.value?.block ?? null) : null,
  );

  constructor(private readonly connection: Connection) {
    connection.on("Opened", (opened) => {
      this.robot.value = opened.robot;
      this.world.value = opened.world;
      this.breakpoints.value = new Set(opened.breakpoints);
      this.state.value = IDLE;
      this.variables.value = this.ended.value = this.telemetry.value = this.line.value = this.link.value = null;
    });
    connection.on("Settings", (settings) => {
      this.robot.value = settings.robot;
      this.world.value = settings.world;
      this.breakpoints.value = new Set(settings.breakpoints);
    });
    connection.on("RunState", (state) => {
      // It is idle again once the user has chosen another world.
      if (state.state === "starting" || state.state === "idle")
        this.variables.value = this.ended.value = this.line.value = null;
      this.state.value = state;
    });
    connection.on("Telemetry", (telemetry) => (this.telemetry.value = telemetry));
    connection.on("RunningLine", (line) => (this.line.value = line));
    connection.on("RobotLink", (link) => (this.link.value = link));
    connection.on("Variables", (variables) => (this.variables.value = variables));
    connection.on("Scene", (scene) => (this.scene.value = scene));
    // A test run of a custom block is not a run of the program.
    connection.on("Ended", (ended) => (this.ended.value = ended.tried ? null : ended));
  }

  toggleBreakpoint(block: string): void {
    const blocks = new Set(this.breakpoints.value);
    if (!blocks.delete(block)) blocks.add(block);
    this.breakpoints.value = blocks;
    this.connection.send({ kind: "SetBreakpoints", blocks: [...blocks] });
  }
}
