/** Which robots can run the program; the server is asked only while the list is shown. */

import { effect, type ReadonlySignal, signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { Verdict } from "../protocol/messages";
import { Throttle } from "../ui/throttle";
import type { Program } from "./program";

/** ms between two questions while the program is being edited. */
const PERIOD = 500;

export class RunsOn {
  /** A verdict for each robot; empty until the server has answered. */
  readonly verdicts = signal<readonly Verdict[]>([]);

  constructor(
    private readonly connection: Connection,
    private readonly program: Program,
    /** The name of the open project; empty while there is none. */
    private readonly project: ReadonlySignal<string>,
  ) {
    connection.on("RunsOn", ({ robots }) => (this.verdicts.value = robots));
  }

  /** Keep the verdicts up to date while they are shown, until the function that it returns is called. */
  watch(isShown: () => boolean): () => void {
    const throttle = new Throttle(PERIOD);
    const stop = effect(() => {
      this.program.state.value;
      if (this.project.value && isShown()) throttle.do(() => this.connection.send({ kind: "ReadRunsOn" }));
    });
    return () => {
      stop();
      throttle.cancel();
    };
  }
}
