import { expect, test } from "vitest";

import { branches } from "../../src/model/line-in-view";

test("elif and else of a statement are found, and not those inside it", () => {
  const text = ["x = 1", "if a:", "    if b:", "        c", "    else:", "        d", "    end", "elif e:", "    f"];
  const all = [...text, "else:", "    g", "end", "else:"].join("\n");
  expect(branches(all, 2, 12)).toEqual([8, 10]);
  expect(branches(all, 3, 7)).toEqual([5]);
});
