import { signal } from "@preact/signals";
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

test("an error that can be fixed goes once it is fixed, and no other does", async () => {
  const toasts = new Toasts();
  const isFixed = signal(false);
  toasts.errorUntil(() => isFixed.value, "a value is missing");
  toasts.error("disk full");
  await Promise.resolve();
  expect(texts(toasts)).toEqual(["a value is missing", "disk full"]);
  isFixed.value = true;
  await Promise.resolve();
  expect(texts(toasts)).toEqual(["disk full"]);
});

test("a note with an action stays until the user dismisses it", () => {
  const toasts = new Toasts();
  toasts.show({ sort: "note", text: "deleted", action: { text: "Restore", run: () => {} } });
  toasts.note("saved");
  vi.runAllTimers();
  expect(texts(toasts)).toEqual(["deleted"]);
});
