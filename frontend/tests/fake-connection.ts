import { signal } from "@preact/signals";

import type { Phrase } from "../src/i18n";
import type { Connection, ConnectionState } from "../src/protocol/connection";
import type { FromPage, ToPage } from "../src/protocol/messages";

/** A connection whose other end is the test. */
export class FakeConnection {
  readonly state = signal<ConnectionState>("open");
  readonly sent: FromPage[] = [];
  private readonly listeners: [string, (message: ToPage) => void][] = [];

  send(message: FromPage): boolean {
    this.sent.push(message);
    return true;
  }

  on(kind: string, listener: (message: ToPage) => void): () => void {
    this.listeners.push([kind, listener]);
    return () => undefined;
  }

  onRefused(requests: readonly string[], listener: (reason: Phrase) => void): () => void {
    return this.on("Failed", (failed) => {
      if (failed.kind === "Failed" && requests.includes(failed.request ?? "")) listener(failed.message);
    });
  }

  /** Receive a message; what a test does not care about may be missing. */
  tell(message: { readonly kind: ToPage["kind"] } & Readonly<Record<string, unknown>>): void {
    for (const [kind, listener] of this.listeners) if (kind === message.kind) listener(message as unknown as ToPage);
  }

  get real(): Connection {
    return this as unknown as Connection;
  }
}
