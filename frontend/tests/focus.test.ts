/** What takes the focus takes it at once: an effect after the next frame would take it back from what is used next. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { expect, test } from "vitest";

const SOURCES = fileURLToPath(new URL("../src", import.meta.url));

/** Each call of `useEffect` in a file, with its arguments. */
function effects(code: string): string[] {
  return [...code.matchAll(/\buseEffect\(/g)].map(({ index }) =>
    code.slice(index, end(code, code.indexOf("(", index))),
  );
}

/** The place behind the bracket that closes the one at a place. */
function end(code: string, start: number): number {
  let depth = 0;
  for (let at = start; at < code.length; at += 1) {
    if (code[at] === "(") depth += 1;
    if (code[at] === ")") depth -= 1;
    if (depth === 0) return at + 1;
  }
  return code.length;
}

test("nothing takes the focus in an effect that waits for a frame", () => {
  const all = readdirSync(SOURCES, { recursive: true, encoding: "utf-8" });
  const files = all.filter((path) => path.endsWith(".tsx"));
  expect(files.length).toBeGreaterThan(100);
  const late = files.filter((file) =>
    effects(readFileSync(join(SOURCES, file), "utf-8")).some((text) => /\bfocus\(/.test(text)),
  );
  expect(late).toEqual([]);
});
