/** Sends the server a file as it is, without a message around it. */

import type { Phrase } from "../i18n";

/** What the server says of a file: its answer, or why it refuses it; neither if it could not be reached. */
export interface FileAnswer<Answer> {
  readonly answer?: Answer;
  readonly refusal?: Phrase;
}

/** Send the server a file. */
export async function sendFile<Answer>(address: string, file: File): Promise<FileAnswer<Answer>> {
  try {
    const reply = await fetch(address, { method: "POST", body: file });
    const content = await reply.json();
    return reply.ok ? { answer: content as Answer } : { refusal: content as Phrase };
  } catch {
    return {};
  }
}
