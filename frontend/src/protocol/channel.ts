/** A websocket with messages of two unions; it reconnects automatically. */

import { signal } from "@preact/signals";

/**
 * Two are final: `refused`, since the server has a different token, for example after a restart, and `crowded`, since
 * this person has too many pages open.
 */
export type ConnectionState = "connecting" | "open" | "lost" | "refused" | "crowded";

interface Kind {
  readonly kind: string;
}

type Listener = (message: never) => void;

const FIRST_DELAY = 250;
const LONGEST_DELAY = 4000;
/** The codes with which the server closes the websocket if retrying would not help. */
const FINAL: Readonly<Record<number, ConnectionState>> = { 4403: "refused", 4429: "crowded" };

/** The address of a websocket of the server, relative to the page or another address of it: a proxy may add a path. */
export function socketAt(name: string, base: string | URL = location.href): URL {
  const address = new URL(name, base);
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  return address;
}

export class Channel<Sent extends Kind, Received extends Kind> {
  readonly state = signal<ConnectionState>("connecting");
  private socket: WebSocket | null = null;
  private listeners = new Map<string, Set<Listener>>();
  private delay = FIRST_DELAY;

  constructor(
    private readonly address: URL,
    private readonly protocols: readonly string[] = [],
  ) {}

  open(): void {
    const socket = new WebSocket(this.address, [...this.protocols]);
    socket.binaryType = "blob";
    socket.onopen = () => {
      this.delay = FIRST_DELAY;
      this.state.value = "open";
    };
    socket.onmessage = (event: MessageEvent<string | Blob>) => this.receive(event.data);
    socket.onclose = (event) => this.closed(event.code);
    this.socket = socket;
  }

  /** Send a message; return false and drop it while there is no connection. */
  send(message: Sent): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  /** Listen to messages of one kind; call the result to stop. */
  on<K extends Received["kind"]>(kind: K, listener: (message: Extract<Received, { kind: K }>) => void): () => void {
    const known = this.listeners.get(kind) ?? new Set<Listener>();
    this.listeners.set(kind, known);
    known.add(listener);
    return () => known.delete(listener);
  }

  protected receive(data: string | Blob): void {
    if (!(data instanceof Blob)) this.received(JSON.parse(data) as Received);
  }

  protected received(message: Received): void {
    for (const listener of this.listeners.get(message.kind) ?? []) listener(message as never);
  }

  private closed(code: number): void {
    this.state.value = FINAL[code] ?? "lost";
    if (code in FINAL) return;
    setTimeout(() => this.open(), this.delay);
    this.delay = Math.min(this.delay * 2, LONGEST_DELAY);
  }
}
