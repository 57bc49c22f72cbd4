import { expect, test } from "vitest";

import { fileName } from "../../src/features/world-editor/saving";

test.each([
  ["My maze", "My maze"],
  ["Ana's room!", "Ana s room"],
  ["  Pista ñandú 2 ", "Pista ñandú 2"],
  ["../../etc/passwd", "etc passwd"],
  ["a".repeat(50), "a".repeat(40)],
])("the world %s is saved in the file %s", (title, name) => expect(fileName(title)).toBe(name));
