import { expect, test } from "vitest";

import { repeated, Unsaved } from "../../src/model/unsaved";

test("the draft of a view is what was saved and every edit since", () => {
  const unsaved = new Unsaved();
  unsaved.add(1, "python", "a", "");
  unsaved.add(2, "python", "ab", "a");
  unsaved.add(3, "blocktext", "x", "");
  expect(unsaved.drafts).toEqual([
    { view: "python", steps: ["", "a", "ab"] },
    { view: "blocktext", steps: ["", "x"] },
  ]);
});

test("a saved edit is what the later ones are based on", () => {
  const unsaved = new Unsaved();
  for (const [index, text] of ["a", "ab", "abc"].entries()) unsaved.add(index + 1, "python", text, "");
  unsaved.saved(2);
  expect(unsaved.drafts).toEqual([{ view: "python", steps: ["ab", "abc"] }]);
  unsaved.saved(3);
  expect(unsaved.drafts).toEqual([]);
});

test("an answer without the edit, after an undo, is the draft", () => {
  const unsaved = new Unsaved();
  unsaved.add(1, "python", "a", "");
  unsaved.answered("python", "");
  unsaved.answered("blocktext", "");
  expect(unsaved.drafts).toEqual([{ view: "python", steps: ["", ""] }]);
});

test("what is saved stays in a draft however long the server is away", () => {
  const unsaved = new Unsaved();
  for (let number = 1; number < 1000; number++) unsaved.add(number, "python", `x = ${number}`, "saved");
  const [{ steps } = { steps: [] }] = unsaved.drafts;
  expect(steps.length).toBeLessThan(40);
  expect([steps[0], steps.at(-1)]).toEqual(["saved", "x = 999"]);
});

test("a draft of blocks has no steps in between, which would be large", () => {
  const unsaved = new Unsaved();
  const blocks = ["a", "b", "c"].map((id) => ({ stacks: [[{ type: "lb_main", id }]], variables: [] }));
  const [first, second, third] = blocks;
  if (!first || !second || !third) throw new Error("three workspaces");
  unsaved.add(1, "blocks", second, first);
  unsaved.add(2, "blocks", third, second);
  expect(unsaved.drafts).toEqual([{ view: "blocks", steps: [first, third] }]);
});

test.each([
  ["the server has none of the edits", "a", "a"],
  ["the server has an edit that it has not called saved", "a\nb", "a\nb"],
  ["others have edited other lines", "x\na\nb\ny", "a\nb"],
  ["another user has changed the same line", "z", "a"],
])("where %s, the draft repeats an edit of the nearest step", (_, now, base) => {
  const steps = ["a", "a\nb", "a\nbc"];
  expect(repeated({ view: "python", steps }, now)).toEqual({ view: "python", base, content: "a\nbc" });
});
