/** Lets the server make a robot from its description; the text is kept until that succeeds. */

import { signal } from "@preact/signals";
import { t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import { type FromPage, LIMITS, type RobotMade, type RobotProblem } from "../../protocol/messages";
import { readText } from "../../ui/files";

export class RobotMaker {
  readonly name = signal("");
  /** TOML. */
  readonly description = signal("");
  readonly problems = signal<readonly RobotProblem[]>([]);
  /** The robot made last. */
  readonly made = signal<RobotMade | null>(null);

  constructor(private readonly connection: Connection) {
    connection.on("RobotBegun", ({ description }) => (this.description.value ||= description));
    connection.on("RobotMade", (made) => this.receive(made));
  }

  /** Continue with the current text, or start with the server's template. */
  begin(): void {
    this.problems.value = [];
    this.made.value = null;
    if (!this.description.value) void this.ask({ kind: "BeginRobot" });
  }

  make(): void {
    this.problems.value = [];
    void this.ask({ kind: "MakeRobot", name: this.name.value.trim(), description: this.description.value });
  }

  private async ask(message: FromPage): Promise<void> {
    const answer = await this.connection.ask(message);
    if (answer.kind === "Failed") this.problems.value = [answer];
  }

  /** Use a file's text as the description, and its name if the robot has none yet. */
  async readFile(file: File): Promise<void> {
    if (file.size > LIMITS.MakeRobot.description) return this.refuse("page-newrobot-large", file);
    const text = await readText(file);
    if (text === null) return this.refuse("page-project-not-utf-8", file);
    this.problems.value = [];
    this.description.value = text;
    this.name.value ||= file.name.replace(/\.toml$/, "");
  }

  private refuse(word: string, file: File): void {
    this.problems.value = [{ message: { code: t(word, { name: file.name }) } }];
  }

  private receive(made: RobotMade): void {
    this.problems.value = made.problems ?? [];
    if (this.problems.value.length) return;
    this.made.value = made;
    this.name.value = this.description.value = "";
  }
}

declare module "../../model/page" {
  interface Page {
    readonly robotMaker: RobotMaker;
  }
}
