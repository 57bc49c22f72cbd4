import { expect, test } from "vitest";

import type { Workspace } from "../../../src/protocol/messages";
import { usesGame } from "../../../src/views/blocks/games";

const program = (type: string): Workspace => ({ stacks: [[{ type, id: "a" }]], variables: [] }) as unknown as Workspace;

test.each([
  ["lb_skill_change_score", true],
  ["lb_when_collected", true],
  ["lb_when_is_time_up", true],
  ["lb_skill_turn", false],
  ["lb_when_received", false],
])("a program with %s plays a game: %s", (type, plays) => {
  expect(usesGame(program(type))).toBe(plays);
});
