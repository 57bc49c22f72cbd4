/** Has the server make a robot from its description; what was written stays until that is done. */

import { signal } from "@preact/signals";

import type { Connection } from "../connection";
import { t } from "../i18n";
import type { FromPage, RobotMade, RobotProblem } from "../messages";

const REQUESTS = ["BeginRobot", "MakeRobot"] as const satisfies readonly FromPage["kind"][];

/** As long as the server takes. */
const LONGEST = 65_536;

export class RobotMaker {
  readonly name = signal("");
  /** TOML. */
  readonly description = signal("");
  readonly problems = signal<readonly RobotProblem[]>([]);
  /** What was made last. */
  readonly made = signal<RobotMade | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("RobotBegun", ({ description }) => (this.description.value ||= description));
    connection.on("RobotMade", (made) => this.hear(made));
    connection.onRefused(REQUESTS, (message) => (this.problems.value = [{ message }]));
  }

  /** Go on with what was written, or begin with what the server begins with. */
  begin(): void {
    this.problems.value = [];
    this.made.value = null;
    if (!this.description.value) this.connection.send({ kind: "BeginRobot" });
  }

  make(): void {
    this.problems.value = [];
    this.connection.send({ kind: "MakeRobot", name: this.name.value.trim(), description: this.description.value });
  }

  /** Take a file's text as the description, and its name where there is none yet. */
  async readFile(file: File): Promise<void> {
    this.problems.value = file.size > LONGEST ? [{ message: t("newrobot.large", { name: file.name }) }] : [];
    if (this.problems.value.length) return;
    this.description.value = await file.text();
    this.name.value ||= file.name.replace(/\.toml$/, "");
  }

  private hear(made: RobotMade): void {
    this.problems.value = made.problems ?? [];
    if (this.problems.value.length) return;
    this.made.value = made;
    this.name.value = this.description.value = "";
  }
}
