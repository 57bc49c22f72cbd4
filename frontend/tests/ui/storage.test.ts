import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { inBrowser, UnsavedEdits } from "../../src/ui/storage";

const kept = new Map<string, string>();
const WORKING = {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => kept.set(key, value),
};

function full(): never {
  throw new DOMException("the quota is used up", "QuotaExceededError");
}

beforeEach(() => {
  kept.clear();
  vi.stubGlobal("localStorage", WORKING);
  vi.stubGlobal("sessionStorage", WORKING);
});
afterEach(() => vi.unstubAllGlobals());

test("a text is kept for the next page", () => {
  inBrowser("greeting").write("hello");
  expect(inBrowser("greeting").read()).toBe("hello");
});

test("what a full storage refuses hides the text before it until there is room", () => {
  const stored = inBrowser("greeting");
  stored.write("hello");
  vi.stubGlobal("localStorage", { ...WORKING, setItem: full });
  stored.write("goodbye");
  expect(stored.read()).toBe("goodbye");
  vi.stubGlobal("localStorage", WORKING);
  stored.write("welcome");
  expect(inBrowser("greeting").read()).toBe("welcome");
});

test("a disabled storage keeps a text until the page is closed", () => {
  // Naming it is an error, as where the user has blocked it.
  vi.stubGlobal("localStorage", undefined);
  const stored = inBrowser("greeting");
  expect(stored.read()).toBeNull();
  stored.write("hello");
  expect(stored.read()).toBe("hello");
});

test("another program's text is no value", () => {
  kept.set("edits", "{not JSON");
  expect(inBrowser("edits").readValue()).toBeNull();
});

test("edits are kept and dropped by name", () => {
  const edits = new UnsavedEdits<string>("edits");
  edits.keep("", "new");
  edits.keep("square", "changed");
  edits.drop("");
  expect(edits.read("")).toBeNull();
  expect(new UnsavedEdits("edits").read("square")).toBe("changed");
});

test("a name that every object has is not an edit", () => {
  const edits = new UnsavedEdits<string>("edits");
  expect(edits.read("constructor")).toBeNull();
  edits.keep("__proto__", "changed");
  expect(edits.read("__proto__")).toBe("changed");
});
