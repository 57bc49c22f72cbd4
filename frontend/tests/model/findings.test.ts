import { expect, test } from "vitest";

import type { Context } from "../../src/model/context";
import { warningsAtStart } from "../../src/model/findings";
import type { Problem } from "../../src/protocol/messages";

/** A problem as the server tells it: once for each view. */
function problem(block: string, severity: Problem["severity"]): Problem[] {
  const message = { code: `about ${block}`, values: {} };
  const in_blocks = { code: `about ${block}, in blocks`, values: {} };
  return (["blocks", "blocktext", "python"] as const).map((view) => {
    return { code: "c", message, in_blocks, severity, view, block };
  });
}

function warned(...problems: Problem[][]): [string[], number] {
  const state = { value: { problems: problems.flat(), origin: "blocks" } };
  const { shown, more } = warningsAtStart({ program: { state } } as unknown as Context);
  return [shown.map(({ message }) => message), more];
}

test("a run begins with each warning once, in the words of the view that was edited, without the errors", () => {
  expect(warned(problem("a", "error"), problem("b", "warning"))).toEqual([["about b, in blocks"], 0]);
  expect(warned()).toEqual([[], 0]);
});

test("of many warnings a run begins with three and the number of the others", () => {
  const many = ["a", "b", "c", "d", "e"].map((block) => problem(block, "warning"));
  expect(warned(...many)).toEqual([["a", "b", "c"].map((block) => `about ${block}, in blocks`), 2]);
});
