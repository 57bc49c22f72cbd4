import { expect, test } from "vitest";

import type { Context } from "../../src/model/context";
import { findings, placeText, warningsAtStart } from "../../src/model/findings";
import type { Problem, View } from "../../src/protocol/messages";

/** A problem as the server tells it: once for each text. */
function problem(block: string, severity: Problem["severity"]): Problem[] {
  const message = { code: `about ${block}`, values: {} };
  const in_blocks = { code: `about ${block}, in blocks`, values: {} };
  return (["blocktext", "python"] as const).map((view) => {
    return { code: "c", message, in_blocks, severity, view, block };
  });
}

function warned(...problems: Problem[][]): [string[], number] {
  const state = { value: { problems: problems.flat(), origin: "blocks" } };
  const { shown, more } = warningsAtStart({ program: { state }, openView: { value: "blocks" } } as unknown as Context);
  return [shown.map(({ message }) => message), more];
}

function shown(problems: readonly Problem[], open: View, origin: View): [string, View, number][] {
  return findings(problems, open, origin).map(({ message, place }) => [message, place.view, place.line ?? 0]);
}

/** A mistake whose words and line depend on the text. */
const SKILL: readonly Problem[] = [
  { ...problem("a", "error")[0]!, view: "blocktext", line: 1, message: { code: "Write function.f()" } },
  { ...problem("a", "error")[0]!, view: "python", line: 5, message: { code: "Write robot.f()" } },
];

test("a run begins with each warning once, in the words of the view that is open, without the errors", () => {
  expect(warned(problem("a", "error"), problem("b", "warning"))).toEqual([["about b, in blocks"], 0]);
  expect(warned()).toEqual([[], 0]);
});

test("of many warnings a run begins with three and the number of the others", () => {
  const many = ["a", "b", "c", "d", "e"].map((block) => problem(block, "warning"));
  expect(warned(...many)).toEqual([["a", "b", "c"].map((block) => `about ${block}, in blocks`), 2]);
});

test.each([
  ["blocktext", "blocktext", ["Write function.f()", "blocktext", 1]],
  ["python", "blocktext", ["Write robot.f()", "python", 5]],
  ["blocks", "python", ["about a, in blocks", "blocks", 0]],
] as const)("a mistake is shown once, in %s if that is open", (open, origin, expected) => {
  expect(shown(SKILL, open, origin)).toEqual([expected]);
});

test("two mistakes of one kind in one block stay two", () => {
  const twice = SKILL.flatMap((one) => [one, { ...one, line: one.line! + 1 }]);
  expect(shown(twice, "python", "python").map(([, , line]) => line)).toEqual([5, 6]);
});

test("what only another view has is shown there", () => {
  const [, python] = SKILL;
  expect(shown([{ ...python!, block: null }], "blocks", "blocks")).toEqual([["Write robot.f()", "python", 5]]);
});

test("a mistake in blocks is placed by its block's words", () => {
  const context = { describeStep: () => "turn right by 90°" };
  const place = { ...SKILL[0]!, view: "blocks" as const, line: 0 };
  expect(placeText(context, place)).toBe("page-problems-block");
  // As long as the blocks are not drawn.
  expect(placeText({ describeStep: () => "" }, place)).toBe("page-shell-blocks");
});
