import { expect, test, vi } from "vitest";

import type { Collectable, WorldFile } from "../../../src/protocol/world";
import { GameThings } from "../../../src/views/world/scenery/games";

const KINDS: readonly Collectable["kind"][] = [
  ...(["star", "coin", "gem", "heart", "cherry", "battery", "key", "flag", "bug", "ghost"] as const),
];

const WORLD = {
  collectable: KINDS.map((kind, i) => ({ kind, x: 100 * i, y: 0, radius: 40 })),
  door: [{ x: 0, y: 500, heading: 90, length: 300, width: 20, height: 100, colour: "red" }],
  zone: [{ x: 0, y: -500, radius: 100, colour: "green" }],
  switch: [{ x: 300, y: -500, radius: 80 }],
  gate: [{ x: 600, y: 0, heading: 0, width: 400 }],
} as unknown as WorldFile;

test("a thing that has been collected is out of sight, and the others turn and move", () => {
  const games = new GameThings(WORLD);
  const [star, coin] = games.object.children;
  const places = KINDS.map((_, i): [number, number] | null => (i === 0 ? null : [i, 7]));
  games.show({ time: 1, things: places, doors: [false] });
  const before = coin?.children[0]?.rotation.z;
  games.show({ time: 1.5, things: places, doors: [false] });
  expect(star?.visible).toBe(false);
  expect([coin?.visible, coin?.position.x, coin?.position.y]).toEqual([true, 1, 7]);
  expect(coin?.children[0]?.rotation.z).not.toBe(before);
});

test("an open door is out of sight", () => {
  const games = new GameThings(WORLD);
  const door = games.object.children[KINDS.length];
  const shown = (open: boolean) => {
    games.show({ time: 0, things: KINDS.map(() => null), doors: [open] });
    return door?.visible;
  };
  expect([shown(false), shown(true)]).toEqual([true, false]);
});

test("a world without a game adds nothing, without a complaint of three's", () => {
  const complaint = vi.spyOn(console, "error").mockImplementation(() => undefined);
  const games = new GameThings({ collectable: [], door: [], zone: [], switch: [], gate: [] } as unknown as WorldFile);
  expect(games.object.children).toEqual([]);
  expect(complaint).not.toHaveBeenCalled();
  complaint.mockRestore();
});
