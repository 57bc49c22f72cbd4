import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { startFonts } from "../../src/ui/fonts";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

/** Whether it has returned after these milliseconds. */
async function returned(started: Promise<void>, ms: number): Promise<boolean> {
  let isDone = false;
  void started.then(() => {
    isDone = true;
  });
  await vi.advanceTimersByTimeAsync(ms);
  return isDone;
}

function fontsThat(loaded: Promise<FontFace[]>): FontFaceSet {
  return { load: () => loaded } as unknown as FontFaceSet;
}

test("the page is shown once its letters are there", async () => {
  let come: (faces: FontFace[]) => void = () => {};
  const started = startFonts(fontsThat(new Promise((resolve) => (come = resolve))));
  expect(await returned(started, 1000)).toBe(false);
  come([]);
  expect(await returned(started, 0)).toBe(true);
});

test("letters that do not come are not waited for", async () => {
  const never = new Promise<FontFace[]>(() => {});
  expect(await returned(startFonts(fontsThat(never)), 3000)).toBe(true);
  expect(await returned(startFonts(fontsThat(Promise.reject(new Error("refused")))), 0)).toBe(true);
});
