import { expect, test } from "vitest";

import { columnsFor } from "../../src/features/class-page/fitting";

test.each([
  ["24 pupils", 24, 7],
  ["30 pupils", 30, 8],
  ["more than can be read there, who go on below", 40, undefined],
])("beside the side column of a screen of 1366 x 768 are %s", (_, count, columns) => {
  expect(columnsFor(count, 1050, 650)).toBe(columns);
});

test("a larger screen has larger tiles", () => {
  expect(columnsFor(30, 1600, 960)).toBe(8);
  expect(columnsFor(15, 1600, 960)).toBe(5);
});
