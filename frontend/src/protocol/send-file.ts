/** Requests about files, without a message around them. */

import type { Phrase } from "../i18n";

/** What to say if the server could not be reached. */
export const UNSENT: Phrase = { code: "page-shell-unsent" };

/** What the server says of a file: its answer, or why it refuses it; neither if it could not be reached. */
export interface FileAnswer<Answer> {
  readonly answer?: Answer;
  readonly refusal?: Phrase;
}

/** Send the server a file. */
export function sendFile<Answer>(address: string, file: File): Promise<FileAnswer<Answer>> {
  return ask(address, { method: "POST", body: file });
}

/** Have the server delete a file. */
export function deleteFile<Answer>(address: string): Promise<FileAnswer<Answer>> {
  return ask(address, { method: "DELETE" });
}

async function ask<Answer>(address: string, request: RequestInit): Promise<FileAnswer<Answer>> {
  try {
    const reply = await fetch(address, request);
    const content = await reply.json();
    return reply.ok ? { answer: content as Answer } : { refusal: content as Phrase };
  } catch {
    return {};
  }
}
