import { signal } from "@preact/signals";
import { expect, test, vi } from "vitest";

import { addRobot, canAddRobot } from "../../src/model/missing-robot";
import type { Program } from "../../src/model/program";

const PLAIN = "without robot\n\nfunction.turn(90)\n";
const MISSING = { message: { code: "python-no-robot" } };

function shown(blocktext: string, stale: readonly string[] = [], readOnly: unknown = null) {
  const state = signal({ blocktext, stale });
  return { state, readOnly: signal(readOnly), editedText: vi.fn() } as unknown as Program;
}

test("adding a robot removes one line of Block-Text", () => {
  const program = shown(PLAIN);
  addRobot(program);
  const [notation, read] = vi.mocked(program.editedText).mock.lastCall!;
  expect([notation, read()]).toEqual(["blocktext", "function.turn(90)\n"]);
});

test("a robot is offered only where the program uses one, and can be changed", () => {
  expect(canAddRobot(shown(PLAIN), MISSING)).toBe(true);
  expect(canAddRobot(shown(PLAIN), { message: { code: "check-unknown-name" } })).toBe(false);
  expect(canAddRobot(shown("function.turn(90)\n"), MISSING)).toBe(false);
  expect(canAddRobot(shown(PLAIN, ["blocktext"]), MISSING)).toBe(false);
  expect(canAddRobot(shown(PLAIN, [], { code: "x" }), MISSING)).toBe(false);
});
