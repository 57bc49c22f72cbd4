/** A test run of one function: output, input and result. */

import { computed, signal } from "@preact/signals";

import type { Phrase } from "../../i18n";
import type { Context } from "../../model/context";
import type { Ended } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";

/** Longer output is cut at the start. */
const MOST_OUTPUT = 20_000;

export class Trying {
  readonly output = signal("");
  readonly ended = signal<Ended | null>(null);
  /** Why it could not start. */
  readonly refused = signal<Phrase | string>("");
  /** The prompt while the function waits for input. */
  readonly prompt = signal<string | null>(null);
  /** Whether the current run was started here. */
  readonly active = computed(() => this.begun.value && !this.ended.value && !this.refused.value);
  private readonly begun = signal(false);
  private readonly cleanup: Cleanup;

  constructor(private readonly context: Context) {
    const { connection } = context;
    this.cleanup = new Cleanup(
      connection.on("Printed", ({ text }) => this.print(text)),
      connection.on("PrintedByRobots", ({ parts }) => this.print(parts.map(({ text }) => text).join(""))),
      connection.on("InputWanted", ({ prompt }) => this.ask(prompt)),
      connection.on("Ended", (ended) => this.end(ended)),
    );
  }

  destroy(): void {
    if (this.active.peek()) this.stop();
    this.cleanup.dispose();
  }

  async try(name: string, source: string, skill: string, values: readonly unknown[]): Promise<void> {
    this.output.value = this.refused.value = "";
    this.ended.value = this.prompt.value = null;
    this.begun.value = true;
    const question = { name: name.trim(), source, function: skill, arguments: [...values] };
    const answer = await this.context.connection.ask({ kind: "TryCustomBlock", ...question });
    if (answer.kind === "Failed") this.refused.value = answer.message;
  }

  stop(): void {
    this.context.connection.send({ kind: "Stop" });
  }

  answer(text: string): void {
    this.prompt.value = null;
    this.context.connection.send({ kind: "Answer", text });
  }

  /** The source has changed since the last test run. */
  forget(): void {
    if (!this.active.peek()) this.ended.value = null;
  }

  private ask(prompt: string): void {
    if (this.active.peek()) this.prompt.value = prompt;
  }

  private print(text: string): void {
    if (this.active.peek()) this.output.value = (this.output.peek() + text).slice(-MOST_OUTPUT);
  }

  private end(ended: Ended): void {
    if (ended.tried) this.ended.value = ended;
  }
}
