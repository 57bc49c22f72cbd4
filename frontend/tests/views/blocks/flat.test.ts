import { expect, test } from "vitest";

import type { Block, Workspace } from "../../../src/protocol/messages";
import { index, shadowLinks, shadowOf } from "../../../src/views/blocks/flat";

function block(id: string, inputs: Block["inputs"] = {}): Block {
  return { id, type: "test", inputs } as Block;
}

const loop = block("loop", {
  TIMES: { shadow: block("three"), block: block("count") },
  DO: { stack: [block("first"), block("second")] },
} as Block["inputs"]);
const workspace = { stacks: [[block("start"), loop], [block("alone")]], variables: [] } as Workspace;

test("every block that is not a shadow is found, parents first", () => {
  expect([...index(workspace).keys()]).toEqual(["start", "loop", "count", "first", "second", "alone"]);
});

test("the first block of a stack hangs nowhere", () => {
  const found = index(workspace);
  expect([found.get("start")?.link, found.get("alone")?.link]).toEqual([null, null]);
});

test("a block hangs below the one before it, or in an input", () => {
  const found = index(workspace);
  expect(found.get("loop")?.link).toEqual({ parent: "start", input: "" });
  expect(found.get("first")?.link).toEqual({ parent: "loop", input: "DO" });
  expect(found.get("second")?.link).toEqual({ parent: "first", input: "" });
  expect(found.get("count")?.link).toEqual({ parent: "loop", input: "TIMES" });
});

test("a value is not a statement", () => {
  const statements = [...index(workspace).values()].filter(({ statement }) => statement);
  expect(statements.map((node) => node.block.id)).toEqual(["start", "loop", "first", "second", "alone"]);
});

test("a shadow is found by its input", () => {
  expect(shadowOf(loop, "TIMES")?.id).toBe("three");
  expect(shadowOf(loop, "DO")).toBeNull();
  expect(shadowOf(undefined, "DO")).toBeNull();
});

test("every shadow has its place", () => {
  expect(Object.fromEntries(shadowLinks(index(workspace)))).toEqual({ three: { parent: "loop", input: "TIMES" } });
});
