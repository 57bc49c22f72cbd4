/** Which browser this is: the server keeps apart what several of them have begun. */

import { inBrowser } from "../ui/storage";

const STORED = inBrowser("learnblock.browser");
const VALID = /^[0-9a-f]{32}$/;

/** A random id, which the browser keeps; where storage is disabled, until the page is closed. */
export function browserId(): string {
  const kept = STORED.read() ?? "";
  if (VALID.test(kept)) return kept;
  const made = randomId();
  STORED.write(made);
  return made;
}

/** 128 bits; `crypto.randomUUID` is missing on pages from another computer without HTTPS. */
function randomId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}
