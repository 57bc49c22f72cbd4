import { expect, test } from "vitest";

import { Unsaved } from "../../src/model/unsaved";

test("the draft of a view is its last edit, based on what is saved", () => {
  const unsaved = new Unsaved();
  unsaved.add(1, "python", "a", "");
  unsaved.add(2, "python", "ab", "a");
  unsaved.add(3, "blocktext", "x", "");
  expect(unsaved.drafts).toEqual([
    { view: "python", base: "", content: "ab" },
    { view: "blocktext", base: "", content: "x" },
  ]);
});

test("a saved edit is what the later ones are based on", () => {
  const unsaved = new Unsaved();
  for (const [number, text] of ["a", "ab", "abc"].entries()) unsaved.add(number, "python", text, "");
  unsaved.saved(1);
  expect(unsaved.drafts).toEqual([{ view: "python", base: "ab", content: "abc" }]);
  unsaved.saved(2);
  expect(unsaved.drafts).toEqual([]);
});

test("an answer without the edit, after an undo, is the draft", () => {
  const unsaved = new Unsaved();
  unsaved.add(1, "python", "a", "");
  unsaved.answered("python", "");
  unsaved.answered("blocktext", "");
  expect(unsaved.drafts).toEqual([{ view: "python", base: "", content: "" }]);
});
