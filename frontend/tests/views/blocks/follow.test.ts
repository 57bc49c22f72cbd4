import * as Blockly from "blockly/core";
import { expect, test } from "vitest";

import { areaToFollow } from "../../../src/views/blocks/follow";

const VIEW = { left: 0, width: 400 };
const { Rect } = Blockly.utils;

test("a block that is cut at the side only asks for its height", () => {
  expect(areaToFollow(new Rect(10, 50, 100, 900), VIEW)).toEqual(new Rect(10, 50, 200, 200));
});

test("a block beside the view is brought into it", () => {
  const block = new Rect(10, 50, 500, 900);
  expect(areaToFollow(block, VIEW)).toBe(block);
});
