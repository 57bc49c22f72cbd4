/** The actions of the run buttons and keys. */

import type { Context } from "./context";

export class Controls {
  constructor(private readonly context: Context) {}

  /** Run from the start, or resume a paused program. */
  run(): void {
    const { running } = this.context;
    if (!running.active.value) this.start(false);
    else if (this.context.running.waits.value) this.resume();
  }

  stop(): void {
    this.context.connection.send({ kind: "Stop" });
  }

  /** Run from the start, even while a program is running. */
  restart(): void {
    this.start(false);
  }

  pauseOrResume(): void {
    if (!this.context.running.active.value) return;
    if (this.context.running.waits.value) this.resume();
    else this.context.connection.send({ kind: "Pause" });
  }

  /** Step to the next line; without a run, start and stop at the first line. */
  step(over: boolean): void {
    if (this.context.running.active.value) this.context.connection.send({ kind: "Step", over });
    else this.start(true);
  }

  setSpeed(factor: number | null): void {
    this.context.connection.send({ kind: "SetSpeed", factor });
  }

  chooseRobot(name: string): void {
    this.context.connection.send({ kind: "ChooseRobot", name });
  }

  /** Choose a world, as it is drawn or a variant of it. */
  chooseWorld(name: string, variant = 0): void {
    this.context.connection.send({ kind: "ChooseWorld", name, variant });
  }

  resetWorld(): void {
    this.context.connection.send({ kind: "ResetWorld" });
  }

  private resume(): void {
    this.context.connection.send({ kind: "Resume" });
  }

  private start(paused: boolean): void {
    this.context.program.showAllProblems();
    this.context.connection.send({ kind: "Run", paused });
  }
}
