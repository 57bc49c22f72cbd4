/** Which browser this is: the server keeps apart what several of them have begun. */

const KEY = "learnblock.browser";
const VALID = /^[0-9a-f]{32}$/;

/** A random id, which the browser keeps; where storage is disabled, a new one for each page. */
export function browserId(): string {
  try {
    const kept = localStorage.getItem(KEY) ?? "";
    if (VALID.test(kept)) return kept;
    const made = randomId();
    localStorage.setItem(KEY, made);
    return made;
  } catch {
    return randomId();
  }
}

/** 128 bits; `crypto.randomUUID` is missing on pages from another computer without HTTPS. */
function randomId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}
