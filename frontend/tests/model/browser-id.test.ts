import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { browserId } from "../../src/model/browser-id";

const ID = /^[0-9a-f]{32}$/;
const kept = new Map<string, string>();

beforeEach(() => {
  kept.clear();
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
  });
});

afterEach(() => vi.unstubAllGlobals());

test("a browser keeps its id", () => {
  const id = browserId();
  expect(id).toMatch(ID);
  expect(browserId()).toBe(id);
});

test("two browsers have different ids", () => {
  const id = browserId();
  kept.clear();
  expect(browserId()).not.toBe(id);
});

test("what is no id is replaced", () => {
  kept.set("learnblock.browser", "../../etc");
  expect(browserId()).toMatch(ID);
  expect(kept.get("learnblock.browser")).toMatch(ID);
});

test("without storage there is an id all the same", () => {
  const refuse = () => {
    throw new Error("storage is disabled");
  };
  vi.stubGlobal("localStorage", { getItem: refuse, setItem: refuse });
  expect(browserId()).toMatch(ID);
});
