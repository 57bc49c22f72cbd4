import { beforeEach, expect, test, vi } from "vitest";

const KEPT = new Map<string, string>();

/** Import the module as on a page at that address. */
async function at(href: string) {
  vi.resetModules();
  vi.stubGlobal("location", new URL(href));
  vi.stubGlobal("document", { baseURI: href });
  vi.stubGlobal("localStorage", { getItem: (key: string) => KEPT.get(key) ?? null });
  return await import("../../src/protocol/address");
}

beforeEach(() => {
  KEPT.clear();
});

test("the address for another device has the token and the computer's number", async () => {
  KEPT.set("learnblock.token:/", "secret");
  const { addressElsewhere } = await at("http://127.0.0.1:8421/#project=square");
  expect(addressElsewhere("192.168.1.20")).toBe("http://192.168.1.20:8421/?token=secret#project=square");
  expect(addressElsewhere(null)).toBe(null);
});

test("behind a proxy that logs users in it has no token", async () => {
  const { addressElsewhere } = await at("https://school.example/user/alice/learnblock/#project=square");
  expect(addressElsewhere("10.0.0.2")).toBe("https://school.example/user/alice/learnblock/#project=square");
});
