import { expect, it } from "vitest";

import { isSameProgram } from "../../src/features/lessons/same-program";

it.each([
  ["spaces at its ends", "main:\n    pass\nend", "\nmain:\n  pass\nend\n", true],
  ["a comment", "# Drive.\nmain:\n    # Now.\n    pass\nend", "main:\n    pass\nend", true],
  ["a number", "main:\n    sleep(1)\nend", "main:\n    sleep(2)\nend", false],
  ["a block more", "main:\n    sleep(1)\nend", "main:\n    sleep(1)\n    sleep(1)\nend", false],
])("programs that differ in %s", (_, one, other, same) => {
  expect(isSameProgram(one, other)).toBe(same);
});
