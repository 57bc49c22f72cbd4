/** The websocket to the server, with the messages of `messages.ts` and, in a class, of `classroom.ts`. */

import { Channel } from "./channel";
import type { FromPupil, ToPupil } from "./classroom";
import type { Answers, Done, Failed, FromPage, ToPage } from "./messages";

export type { ConnectionState } from "./channel";

type FrameListener = (jpeg: Blob) => void;

/** What answers a request: `Done`, `Failed`, or the answer that the server says of its kind. */
export type Answer<Request extends FromPage = FromPage> =
  | Done
  | Failed
  | (Request extends { kind: keyof Answers } ? Answers[Request["kind"]] : never);

/** The answer to what cannot be sent, or is not answered any more. */
const UNSENT: Failed = { kind: "Failed", message: { code: "page-shell-unsent" } };

export class Connection extends Channel<FromPage | FromPupil, ToPage | ToPupil> {
  private frameListeners = new Set<FrameListener>();
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private lastRequest = 0;

  constructor(address: URL, token: string) {
    // The token is sent as a subprotocol because addresses end up in logs. In a class there is none.
    super(address, token ? ["learnblock", token] : ["learnblock"]);
    this.state.subscribe((state) => state !== "open" && this.abandon());
  }

  /** Send a message and wait for its answer. Who asks shows a refusal: no toast does. */
  ask<Request extends FromPage>(message: Request): Promise<Answer<Request>> {
    const request = ++this.lastRequest;
    return new Promise((resolve) => {
      // The server answers a request only as its kind says.
      const answered = resolve as (answer: Answer) => void;
      if (this.send({ ...message, request })) this.waiting.set(request, answered);
      else resolve(UNSENT);
    });
  }

  /** React to the server's refusals of these messages, which a toast shows; call the result to stop. */
  onRefused(kinds: readonly FromPage["kind"][], listener: () => void): () => void {
    const known = new Set<string>(kinds);
    return this.on("Failed", ({ refused = "", request = 0 }) => {
      if (!request && known.has(refused)) listener();
    });
  }

  /** Listen to camera frames; a `CameraFrame` message before each frame describes it. */
  onFrame(listener: FrameListener): () => void {
    this.frameListeners.add(listener);
    return () => this.frameListeners.delete(listener);
  }

  protected override receive(data: string | Blob): void {
    if (data instanceof Blob) for (const listener of this.frameListeners) listener(data);
    else super.receive(data);
  }

  protected override received(message: ToPage | ToPupil): void {
    super.received(message);
    if (!("request" in message) || !message.request) return;
    this.waiting.get(message.request)?.(message);
    this.waiting.delete(message.request);
  }

  private abandon(): void {
    for (const resolve of this.waiting.values()) resolve(UNSENT);
    this.waiting.clear();
  }
}
