// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { beforeEach, expect, test, vi } from "vitest";

import { whenNeeded } from "../../src/app/panes/hidden-parts";
import type { Page } from "../../src/model/page";

const isShown = signal(false);
const areLoaded = signal(false);
const scene = signal<object | null>(null);
const active = signal(false);
const page = { views: { areLoaded }, context: { running: { scene, active } } } as unknown as Page;
const load = vi.fn();

beforeEach(() => {
  isShown.value = areLoaded.value = active.value = false;
  scene.value = null;
  load.mockClear();
  vi.stubGlobal("requestIdleCallback", (action: () => void) => action());
  void whenNeeded(page, () => isShown.value).then(load);
});

test("a hidden part of the page waits until the program and its world have been drawn", async () => {
  areLoaded.value = true;
  await Promise.resolve();
  expect(load).not.toHaveBeenCalled();
  scene.value = {};
  await Promise.resolve();
  expect(load).toHaveBeenCalledOnce();
});

test.each([
  ["it is shown", isShown],
  ["a program runs, whose values it shows later", active],
])("a hidden part of the page is loaded at once when %s", async (_, reason) => {
  reason.value = true;
  await Promise.resolve();
  expect(load).toHaveBeenCalledOnce();
});
