import { expect, test } from "vitest";

import { freeTag, isTag, merged, namesOf, row, rowsOf, slipOf } from "../../src/features/tags/rows";

test("names survive the way into rows and back", () => {
  const names = { door: 1, box: 40, "two words": 586 };
  expect(namesOf(rowsOf(names))).toEqual(names);
});

test.each(["0", "8", "586"])("%s is a tag", (tag) => expect(isTag(tag)).toBe(true));
test.each(["587", "-1", "1.5", "door", ""])("%s is not a tag", (tag) => expect(isTag(tag)).toBe(false));

test("a row without a name, with a number for a name or with a wrong number is a slip", () => {
  const slips = [row("", 1), row("12", 1), row("door", "x")].map((one) => slipOf(one, [one]));
  expect(slips).toEqual(["page-tags-no-name", "page-tags-is-number", "page-tags-no-tag"]);
});

test("the second of two equal names is the slip", () => {
  const rows = [row("door", 1), row(" door ", 2)];
  expect(rows.map((one) => slipOf(one, rows))).toEqual([null, "page-tags-twice"]);
});

test("rows with a slip give no names", () => {
  expect(namesOf([row("door", 1), row("", 2)])).toBeNull();
});

test("names of a file replace those of the same name", () => {
  expect(namesOf(merged(rowsOf({ door: 1, box: 2 }), { door: 7 }))).toEqual({ box: 2, door: 7 });
});

test("the first free number is offered", () => {
  expect(freeTag(rowsOf({ a: 0, b: 1, c: 3 }))).toBe(2);
});
