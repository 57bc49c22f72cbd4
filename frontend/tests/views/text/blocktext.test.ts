import { highlightTree } from "@lezer/highlight";
import { expect, test } from "vitest";

import { blocktext } from "../../../src/views/text/blocktext";
import { highlighter } from "../../../src/views/text/highlighter";

/** The words of a text with the kind of each, as the editor colours them. */
function coloured(text: string): string[] {
  const found: string[] = [];
  highlightTree(blocktext.parser.parse(text), highlighter, (from, to, classes) => {
    found.push(`${classes.replace("tok-", "")} ${text.slice(from, to)}`);
  });
  return found;
}

test("forever and wait until are keywords in their statements, and names elsewhere", () => {
  expect(coloured("forever:\n    wait until x\nend")).toEqual([
    "keyword forever",
    "operator :",
    "keyword wait",
    "keyword until",
    "keyword end",
  ]);
  expect(coloured("forever = wait + until")).toEqual(["operator =", "operator +"]);
});

test("local is a keyword before a variable that is set, and a name elsewhere", () => {
  expect(coloured("local x = 1")).toEqual(["keyword local", "operator =", "number 1"]);
  expect(coloured("local = x")).toEqual(["operator ="]);
});

test("a value in a text is coloured as a value, and its braces apart", () => {
  expect(coloured('x = f"at {sqrt(2)} {{m}}" + "{y}"').slice(1)).toEqual([
    'string f"at ',
    "operator {",
    "call sqrt",
    "operator (",
    "number 2",
    "operator )}",
    'string  {{m}}"',
    "operator +",
    'string "{y}"',
  ]);
});

test("an f-string that is never closed ends with its line", () => {
  expect(coloured("x = f'at {y\npass")).toEqual(["operator =", "string f'at ", "operator {", "keyword pass"]);
  expect(coloured("x = f'at\npass").slice(-1)).toEqual(["keyword pass"]);
});
