import { signal } from "@preact/signals";

import type { Answer, Connection, ConnectionState } from "../src/protocol/connection";
import type { FromPage, ToPage } from "../src/protocol/messages";

type Told = { readonly kind: ToPage["kind"] } & Readonly<Record<string, unknown>>;

/** A connection whose other end is the test. */
export class FakeConnection {
  readonly state = signal<ConnectionState>("open");
  readonly sent: FromPage[] = [];
  private readonly listeners = new Set<readonly [string, (message: ToPage) => void]>();
  private readonly waiting: ((answer: Answer) => void)[] = [];

  send(message: FromPage): boolean {
    this.sent.push(message);
    return true;
  }

  ask(message: FromPage): Promise<Answer> {
    this.send(message);
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  on(kind: string, listener: (message: ToPage) => void): () => void {
    const entry = [kind, listener] as const;
    this.listeners.add(entry);
    return () => this.listeners.delete(entry);
  }

  onRefused(kinds: readonly string[], listener: () => void): () => void {
    return this.on("Failed", (failed) => {
      if (failed.kind === "Failed" && kinds.includes(failed.refused ?? "")) listener();
    });
  }

  /** How many listeners have not been stopped: a part of the page that has ended leaves none. */
  get listening(): number {
    return this.listeners.size;
  }

  /** Receive a message; what a test does not care about may be missing. */
  tell(message: Told): void {
    for (const [kind, listener] of this.listeners) if (kind === message.kind) listener(message as unknown as ToPage);
  }

  /** Answer the first request that waits, and let its answer be handled. */
  async answer(message: Told = { kind: "Done" }): Promise<void> {
    this.waiting.shift()!(message as unknown as Answer);
    await Promise.resolve();
    await Promise.resolve();
  }

  /** Refuse the first request that waits. */
  refuse(code: string): Promise<void> {
    return this.answer({ kind: "Failed", message: { code } });
  }

  get real(): Connection {
    return this as unknown as Connection;
  }
}
