import { expect, test } from "vitest";

import { CopiedStatement } from "../../src/model/copied-statement";

const PROGRAM = {
  blocktext: "main:\n    repeat 2:\n        function.turn(90)\n    end\nend\n",
  python: "robot = Robot()\nfor _ in range(2):\n    robot.turn(90)\n",
  places: [
    ["repeat", 2, 4, 2, 3],
    ["turn", 3, 3, 3, 3],
  ] as [string, number, number, number, number][],
};

test("a copied block is the text of its statement, with its body", () => {
  expect(new CopiedStatement().keep(PROGRAM, "repeat")).toBe("repeat 2:\n    function.turn(90)\nend\n");
});

test("a block that the texts do not have is not copied as text", () => {
  expect(new CopiedStatement().keep(PROGRAM, "loose")).toBeNull();
});

test("it is pasted in the notation of the text", () => {
  const copied = new CopiedStatement();
  const text = copied.keep(PROGRAM, "turn")!;
  expect(copied.pasted(text, "blocktext")).toBe("function.turn(90)\n");
  expect(copied.pasted(text, "python")).toBe("robot.turn(90)\n");
});

test("any other text is pasted as it is", () => {
  const copied = new CopiedStatement();
  expect(copied.pasted("x = 1", "python")).toBe("x = 1");
  copied.keep(PROGRAM, "turn");
  expect(copied.pasted("x = 1", "python")).toBe("x = 1");
});
