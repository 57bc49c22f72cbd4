import { beforeAll, expect, test } from "vitest";

import { learnPythonForms, type Part, reworded, sentenceOf } from "../../../src/views/blocks/python-sentences";

const [LINE, BLOCK, VALUE] = ["lb_python_line", "lb_python_block", "lb_python_form"] as const;
const FORMS = [
  [LINE, "import %1 as %2", "use %1 as %2"],
  [LINE, "import %1", "use %1"],
  [LINE, "%1 += %2", "change %1 by %2"],
  [LINE, "%1 = %2", "set %1 to %2"],
  [BLOCK, "else", "if it ended by itself", "for", "while"],
  [BLOCK, "def %1(%2)", "define %1 with %2"],
  [VALUE, "[%1 for %2 in %3]", "for each %2 in %3 a %1"],
] as const;

beforeAll(() => {
  const known = FORMS.map(([type, python, , ...of], at) => ({ type, python, word: `FORM_${at}`, of }));
  learnPythonForms(known, Object.fromEntries(FORMS.map(([, , sentence], at) => [`FORM_${at}`, sentence])));
});

/** A sentence as text: words that can be changed in brackets, sockets as numbers. */
function said(type: string, words: readonly string[], begun = ""): string | null {
  const show = (part: Part) =>
    part.kind === "label" ? part.text : part.kind === "words" ? `[${part.text}]` : `(${part.number})`;
  return sentenceOf(type, words, begun)?.map(show).join(" ") ?? null;
}

test.each([
  [LINE, ["import math"], "use [math]"],
  [LINE, ["import math as m"], "use [math] as [m]"],
  [LINE, ["self.x += ", ""], "change [self.x] by (0)"],
  [LINE, ["self.x = ", ""], "set [self.x] to (0)"],
  [BLOCK, ["def bark(self, times=", ", *, loud=", ")"], "define [bark] with self, times= (0) , *, loud= (1)"],
  [VALUE, ["[", "  for x,y in ", "]"], "for each [x,y] in (1) a (0)"],
])("the sentence of a %s %j is %s", (type, words, sentence) => {
  expect(said(type, words)).toBe(sentence);
});

test.each([
  [LINE, ["self.x -= ", ""]],
  [LINE, ["a == ", ""]],
  [LINE, ["important(", ")"]],
])("a %s %j shows its own words", (type, words) => {
  expect(said(type, words)).toBe(null);
});

test("the sentence of a further part depends on what begins its block", () => {
  expect(said(BLOCK, ["else"], "for")).toBe("if it ended by itself");
  expect(said(BLOCK, ["else"], "try")).toBe(null);
});

test("words of a sentence can be changed, and the others stay as they were", () => {
  const change = { place: "%2", text: "name" };
  expect(reworded(VALUE, ["[", "  for x in ", "]"], "", change)).toEqual(["[", "  for name in ", "]"]);
  expect(reworded(LINE, ["import math as m"], "", change)).toEqual(["import math as name"]);
});
