import { expect, test } from "vitest";

import type { Place } from "../../../src/protocol/messages";
import { Outline } from "../../../src/views/text/outline";

const PLACES: readonly Place[] = [
  ["loop", 1, 4, 3, 5],
  ["inner", 2, 3, 4, 5],
  ["after", 5, 5, 6, 6],
  ["only-blocks", 0, 0, 0, 0],
];

test("a loop's head ends where its body begins", () => {
  expect(new Outline(PLACES, "blocktext").head("loop")).toEqual({ first: 1, last: 1 });
});

test("a statement without a body is its own head", () => {
  expect(new Outline(PLACES, "blocktext").head("inner")).toEqual({ first: 2, last: 3 });
});

test("a statement that the text does not show has no lines", () => {
  expect(new Outline(PLACES, "blocktext").head("only-blocks")).toBeNull();
});

test("a line belongs to the innermost statement", () => {
  const outline = new Outline(PLACES, "blocktext");
  expect([1, 2, 3, 4, 5, 6].map((line) => outline.around(line))).toEqual([
    "loop",
    "inner",
    "inner",
    "loop",
    "after",
    null,
  ]);
});

test("only a statement's first line begins it", () => {
  const outline = new Outline(PLACES, "blocktext");
  expect([1, 2, 3, 5].map((line) => outline.beginningAt(line))).toEqual(["loop", "inner", null, "after"]);
});

test("each text has its own lines", () => {
  expect(new Outline(PLACES, "python").head("loop")).toEqual({ first: 3, last: 3 });
});
