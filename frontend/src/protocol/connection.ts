/** The websocket to the server, with the messages of `messages.ts` and, in a class, of `classroom.ts`. */

import type { Phrase } from "../i18n";
import { Channel } from "./channel";
import type { FromPupil, ToPupil } from "./classroom";
import type { FromPage, ToPage } from "./messages";

export type { ConnectionState } from "./channel";

type FrameListener = (jpeg: Blob) => void;

export class Connection extends Channel<FromPage | FromPupil, ToPage | ToPupil> {
  private frameListeners = new Set<FrameListener>();

  constructor(address: URL, token: string) {
    // The token is sent as a subprotocol because addresses end up in logs. In a class there is none.
    super(address, token ? ["learnblock", token] : ["learnblock"]);
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

  protected override receive(data: string | Blob): void {
    if (data instanceof Blob) for (const listener of this.frameListeners) listener(data);
    else super.receive(data);
  }
}
