// @vitest-environment happy-dom

import { expect, test } from "vitest";

import { room } from "../../src/ui/screen";

/** Give the window a size. */
function size(width: number, height: number): void {
  (window as unknown as { happyDOM: { setViewport(size: object): void } }).happyDOM.setViewport({ width, height });
}

test.each([
  [390, 844, "narrow"],
  [844, 390, "narrow"],
  [932, 430, "narrow"],
  [820, 1180, "medium"],
  [1024, 600, "wide"],
  [1366, 768, "wide"],
] as const)("a screen of %i x %i is %s", (width, height, expected) => {
  size(width, height);
  expect(room.value).toBe(expected);
});
