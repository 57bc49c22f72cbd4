import { expect, test } from "vitest";

import { otherNames } from "../../../src/views/blocks/other-names";

test("a block has the message with its names elsewhere, and none if it has no such names", () => {
  const code = (name: string) => name;
  expect(otherNames("controls_repeat_ext", code)).toBe("page-help-name-repeat");
  expect(otherNames("lb_skill_turn_90_left", code)).toBe("page-help-name-turn");
  expect(otherNames("lb_skill_look_floor", code)).toBe("");
});
