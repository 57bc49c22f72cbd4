import { expect, test } from "vitest";

import { lineIn } from "../../src/model/line-in-view";
import type { Place } from "../../src/protocol/messages";

const IF: Place = ["a", 1, 5, 5, 8];
const TEXTS = {
  blocktext: "if x:\n    f()\nelif y:\n    g()\nend\n",
  python: "from r import Robot\n\nrobot = Robot()\n\nif x:\n    f()\nelif y:\n    g()\n",
};

test("an error in a condition further down is placed at its line in each text", () => {
  expect(lineIn("python", TEXTS, IF, 7)).toBe(7);
  expect(lineIn("blocktext", TEXTS, IF, 7)).toBe(3);
});

test("an error in raw Python is placed at the same line of Block-Text", () => {
  const raw = { blocktext: "# python\nimport math\nmath.sqrt(-1)\n# end\n", python: "import math\nmath.sqrt(-1)\n" };
  expect(lineIn("blocktext", raw, ["a", 1, 4, 1, 2], 2)).toBe(3);
});

test("a line that is not known is that of the statement", () => {
  expect(lineIn("python", TEXTS, IF, 0)).toBe(5);
  expect(lineIn("blocktext", TEXTS, IF, 0)).toBe(1);
});
