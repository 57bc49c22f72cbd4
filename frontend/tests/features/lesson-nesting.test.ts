import { expect, test } from "vitest";

import { depths } from "../../src/features/lessons/nesting";

test("a piece is inside of the blocks that are open before it", () => {
  expect(depths(["repeat 2:", "function.turn(90)", "function.stop_bot()"])).toEqual([0, 1, 1]);
  expect(depths(["repeat 2:", "function.turn(90)", "end", "function.stop_bot()"])).toEqual([0, 1, 0, 0]);
});

test("else is beside its if", () => {
  const pieces = ["forever:", "if a():", "b()", "elif c():", "d()", "else:", "e()"];
  expect(depths(pieces)).toEqual([0, 1, 2, 1, 2, 1, 2]);
});

test("a part of the program ends what is before it", () => {
  expect(depths(["def go():", "repeat 2:", "turn()", "main:", "go()"])).toEqual([0, 1, 2, 0, 1]);
});

test("an order that is no program has depths, too", () => {
  expect(depths(["end", "else:", "a()", "end", "end"])).toEqual([0, 0, 1, 0, 0]);
});
