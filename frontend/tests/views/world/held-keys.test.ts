// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { expect, test } from "vitest";

import type { Context } from "../../../src/model/context";
import { describeKeys, HeldKeys, type Key, keyOf } from "../../../src/views/world/held-keys";
import { FakeConnection } from "../../fake-connection";

const WANTED: readonly Key[] = ["up", "space", "enter", "w", "7"];

test("a pressed key is named as in programs", () => {
  const named = ["ArrowUp", " ", "Enter", "w", "7"].map((key) => keyOf({ key }, WANTED));
  expect(named).toEqual(WANTED);
});

test("a letter is the same key with Shift", () => {
  expect(keyOf({ key: "W" }, WANTED)).toBe("w");
});

test("keys that the program does not ask for stay with the page", () => {
  const named = ["ArrowDown", "o", "Escape", "Tab"].map((key) => keyOf({ key }, WANTED));
  expect(named).toEqual([undefined, undefined, undefined, undefined]);
});

test("the keys are shown as on the keyboard", () => {
  expect(describeKeys(["up", "left", "w", "7"])).toBe("↑ ← W 7");
});

test("a key that is down when the program begins to listen is held, and sent once however often it repeats", () => {
  const connection = new FakeConnection();
  const keys = signal<readonly Key[]>([]);
  const frame = document.createElement("div");
  const context = { connection: connection.real, running: { keys, listeners: signal(1) } } as unknown as Context;
  const held = new HeldKeys(frame, context);
  const press = (repeat: boolean) =>
    frame.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp", code: "ArrowUp", repeat }));
  press(false);
  keys.value = ["up"];
  for (const _ of "123") press(true);
  expect(connection.sent).toEqual([{ kind: "HoldKeys", keys: ["up"] }]);
  held.destroy();
});
