import { expect, test } from "vitest";

import { sidesToFollow } from "../../../src/views/blocks/follow";

const VIEW = { left: 0, width: 400 };

test("a block that is cut at the side does not move the program sideways", () => {
  expect(sidesToFollow({ left: 100, right: 900 }, VIEW)).toEqual({ left: 200, right: 200 });
});

test("a block beside the view is brought into it", () => {
  expect(sidesToFollow({ left: 500, right: 900 }, VIEW)).toEqual({ left: 500, right: 900 });
});
