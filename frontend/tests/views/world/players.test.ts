// @vitest-environment happy-dom
import { signal } from "@preact/signals";
import { expect, test } from "vitest";

import type { CameraMode } from "../../../src/views/world/cameras";
import { Players } from "../../../src/views/world/players";

const NAMES = ["wasd", "arrows", "third"];

function players(...names: string[]) {
  const mode = signal<CameraMode>("follow");
  const own = new Players(mode, (next) => (mode.value = next));
  own.size(1200, 700, { top: 0, bottom: 0 });
  own.join(names.map((name) => ({ name, color: `color of ${name}` })));
  return { own, mode };
}

function kinds({ own }: ReturnType<typeof players>): string[] {
  return own.views.value.map(({ kind }) => kind);
}

/** The number of the view that is chosen. */
function chosen({ own }: ReturnType<typeof players>): number {
  return own.views.value.findIndex(({ on }) => on);
}

test("one robot leaves nothing to choose", () => {
  expect(players("program").own.views.value).toEqual([]);
});

test("two robots are followed together, side by side, or one of them", () => {
  const two = players("wasd", "arrows");
  expect(kinds(two)).toEqual(["all", "split", "one", "one"]);
  expect(chosen(two)).toBe(0);
  expect(two.own.followed(2)).toEqual([0, 1]);
  expect(two.own.lenses).toEqual([]);
});

test("side by side, the halves are named and stay where they are when another tab is chosen", () => {
  const two = players("wasd", "arrows");
  two.own.views.value[1]?.choose();
  expect(two.mode.value).toBe("split");
  expect(two.own.lenses).toHaveLength(2);
  expect([...two.own.dom.children].map(({ textContent }) => textContent)).toEqual(["arrows", "wasd"]);
  expect(two.own.followed(2)).toEqual([1, 0]);
  two.own.join(["arrows", "wasd"].map((name) => ({ name, color: null })));
  expect(two.own.followed(2)).toEqual([0, 1]);
  expect(two.mode.value).toBe("split");
});

test("with three robots, ours is beside each other one", () => {
  const three = players(...NAMES);
  expect(kinds(three)).toEqual(["all", "split", "split", "one", "one", "one"]);
});

test("another camera ends the view side by side", () => {
  const two = players("wasd", "arrows");
  two.own.views.value[1]?.choose();
  two.mode.value = "top";
  expect(two.own.lenses).toEqual([]);
  expect(two.own.dom.childElementCount).toBe(0);
  expect(chosen(two)).toBe(-1);
});

test("a robot that is gone is no longer followed", () => {
  const three = players(...NAMES);
  three.own.views.value.at(-1)?.choose();
  expect(three.own.alone).toBe(0);
  three.own.join([
    { name: "arrows", color: null },
    { name: "third", color: null },
  ]);
  expect(three.own.alone).toBeNull();
  expect(chosen(three)).toBe(0);
});

test("a key goes through all views, and begins again", () => {
  const two = players("wasd", "arrows");
  const passed = Array.from({ length: 4 }, () => {
    two.own.next();
    return chosen(two);
  });
  expect(passed).toEqual([1, 2, 3, 0]);
});
