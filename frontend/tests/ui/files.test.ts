/** Reading a file that the user has chosen. */

import { expect, test } from "vitest";

import { readText } from "../../src/ui/files";

const file = (...bytes: number[]) => new File([new Uint8Array(bytes)], "square.bt");

test("text in UTF-8 is read", async () => {
  expect(await readText(file(0xc3, 0xb1, 0x0a))).toBe("ñ\n");
});

test("a byte order mark is no part of the text", async () => {
  expect(await readText(file(0xef, 0xbb, 0xbf, 0x78))).toBe("x");
});

test("a file in Latin-1 is refused, because its letters would be lost", async () => {
  expect(await readText(file(0x6e, 0xf1, 0xf6))).toBeNull();
});

test("an empty file is an empty text", async () => {
  expect(await readText(file())).toBe("");
});
