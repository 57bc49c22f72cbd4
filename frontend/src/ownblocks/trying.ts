/** A run of one function on its own: what it prints, what it asks, how it ends. */

import { computed, signal } from "@preact/signals";

import type { Context } from "../context";
import type { Ended } from "../messages";

/** Of what it prints the end is shown. */
const MOST_OUTPUT = 20_000;

export class Trying {
  readonly output = signal("");
  readonly ended = signal<Ended | null>(null);
  /** Why it could not begin. */
  readonly refused = signal("");
  /** What it asks for, while it does. */
  readonly prompt = signal<string | null>(null);
  /** Whether what runs now was begun here. */
  readonly active = computed(() => this.begun.value && !this.ended.value && !this.refused.value);
  private readonly begun = signal(false);
  private readonly ends: (() => void)[];

  constructor(private readonly context: Context) {
    const { connection } = context;
    this.ends = [
      connection.on("Printed", ({ text }) => this.print(text)),
      connection.on("InputWanted", ({ prompt }) => this.active.peek() && (this.prompt.value = prompt)),
      connection.on("Ended", (ended) => this.end(ended)),
      connection.onRefused(["TryOwnBlock"], (reason) => (this.refused.value = reason)),
    ];
  }

  destroy(): void {
    if (this.active.peek()) this.stop();
    for (const end of this.ends) end();
  }

  try(name: string, source: string, skill: string, values: readonly unknown[]): void {
    this.output.value = this.refused.value = "";
    this.ended.value = this.prompt.value = null;
    this.begun.value = true;
    const question = { name: name.trim(), source, function: skill, arguments: [...values] };
    this.context.connection.send({ kind: "TryOwnBlock", ...question });
  }

  stop(): void {
    this.context.connection.send({ kind: "Stop" });
  }

  answer(text: string): void {
    this.prompt.value = null;
    this.context.connection.send({ kind: "Answer", text });
  }

  /** What was tried is no longer what is written. */
  forget(): void {
    if (!this.active.peek()) this.ended.value = null;
  }

  private print(text: string): void {
    if (this.active.peek()) this.output.value = (this.output.peek() + text).slice(-MOST_OUTPUT);
  }

  private end(ended: Ended): void {
    if (ended.tried) this.ended.value = ended;
  }
}
