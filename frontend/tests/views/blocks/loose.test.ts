import { expect, test } from "vitest";

import { isPart } from "../../../src/views/blocks/loose";

test.each([
  [["lb_main"], true],
  [["procedures_defreturn"], true],
  [["lb_comment", "lb_comment"], true],
  [["lb_comment", "lb_pass"], false],
  [["lb_skill_turn"], false],
  [["math_number"], false],
])("a stack of %s runs: %s", (types, runs) => {
  expect(isPart(types)).toBe(runs);
});
