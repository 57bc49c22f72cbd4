/** The websocket to the server, with the messages of `messages.ts`; it reconnects automatically. */

import { signal } from "@preact/signals";

import type { Phrase } from "../i18n";
import type { FromPage, ToPage } from "./messages";

type Listener = (message: ToPage) => void;
type FrameListener = (jpeg: Blob) => void;
/** `refused` is final: the server has a different token, for example after a restart. */
export type ConnectionState = "connecting" | "open" | "lost" | "refused";

const FIRST_DELAY = 250;
const LONGEST_DELAY = 4000;
/** The server closes the websocket with this code if the token is wrong; retrying would not help. */
const FORBIDDEN = 4403;

export class Connection {
  readonly state = signal<ConnectionState>("connecting");
  private socket: WebSocket | null = null;
  private listeners = new Map<string, Set<Listener>>();
  private frameListeners = new Set<FrameListener>();
  private delay = FIRST_DELAY;

  constructor(
    private readonly address: URL,
    private readonly token: string,
  ) {}

  open(): void {
    // The token is sent as a subprotocol because addresses end up in logs.
    const socket = new WebSocket(this.address, ["learnblock", this.token]);
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
  send(message: FromPage): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  /** Listen to messages of one kind; call the result to stop. */
  on<K extends ToPage["kind"]>(kind: K, listener: (message: Extract<ToPage, { kind: K }>) => void): () => void {
    const known = this.listeners.get(kind) ?? new Set<Listener>();
    this.listeners.set(kind, known);
    known.add(listener as Listener);
    return () => known.delete(listener as Listener);
  }

  /** Listen to the server's refusals of these requests; call the result to stop. */
  onRefused(requests: readonly FromPage["kind"][], listener: (reason: Phrase) => void): () => void {
    const known = new Set<string>(requests);
    return this.on("Failed", ({ message, request = "" }) => {
      if (known.has(request)) listener(message);
    });
  }

  /** Listen to camera frames; a `CameraFrame` message before each frame describes it. */
  onFrame(listener: FrameListener): () => void {
    this.frameListeners.add(listener);
    return () => this.frameListeners.delete(listener);
  }

  private receive(data: string | Blob): void {
    if (data instanceof Blob) {
      for (const listener of this.frameListeners) listener(data);
      return;
    }
    const message = JSON.parse(data) as ToPage;
    for (const listener of this.listeners.get(message.kind) ?? []) listener(message);
  }

  private closed(code: number): void {
    this.state.value = code === FORBIDDEN ? "refused" : "lost";
    if (code === FORBIDDEN) return;
    setTimeout(() => this.open(), this.delay);
    this.delay = Math.min(this.delay * 2, LONGEST_DELAY);
  }
}
