import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { Toasts } from "../../src/ui/toasts";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function texts(toasts: Toasts): string[] {
  return toasts.shown.value.map(({ text }) => text);
}

test("a note goes by itself and an error stays", () => {
  const toasts = new Toasts();
  toasts.note("saved");
  toasts.error("disk full");
  vi.runAllTimers();
  expect(texts(toasts)).toEqual(["disk full"]);
});

test("the same text is shown once, as the newest", () => {
  const toasts = new Toasts();
  for (const text of ["a", "b", "a"]) toasts.error(text);
  expect(texts(toasts)).toEqual(["b", "a"]);
});

test("only the newest four are shown", () => {
  const toasts = new Toasts();
  for (const text of ["a", "b", "c", "d", "e"]) toasts.error(text);
  expect(texts(toasts)).toEqual(["b", "c", "d", "e"]);
});
