import { expect, test } from "vitest";

import { matching, sectionsOf } from "../../src/features/help/docs";

const PAGE =
  "# Robots\n\nAll of them.\n\n## Wi-Fi\n\nSee [the page](page.md) or [home](https://example.org).\n\n```\n# no heading\n```\n\n## Empty\n";

test("a page is cut at its headings, and sections without a text are left out", () => {
  expect(sectionsOf(PAGE).map(({ page, heading }) => [page, heading])).toEqual([
    ["Robots", "Robots"],
    ["Robots", "Wi-Fi"],
  ]);
});

test("links to other files are only words", () => {
  expect(sectionsOf(PAGE)[1]?.text).toContain("See the page or [home](https://example.org).");
});

test("sections with all words are found, those with the words in their heading first", () => {
  const sections = sectionsOf("# A\n\nabout a loop\n\n## Loops\n\nthey repeat\n\n## Other\n\nnothing\n");
  expect(matching(sections, "loop", 9).map(({ heading }) => heading)).toEqual(["Loops", "A"]);
  expect(matching(sections, "loop repeat", 9).map(({ heading }) => heading)).toEqual(["Loops"]);
  expect(matching(sections, "  ", 9)).toEqual([]);
});
