import { expect, test } from "vitest";

import { bands, linesOfStacks } from "../../src/features/share/print-layout";
import type { Block, Place } from "../../src/protocol/messages";

const TEXT = "x = 1\n\n# Go.\nmain:\n    stop()\nend\n";
const start: Block = { type: "lb_start", id: "start", inputs: { DO: { stack: [{ type: "set", id: "set" }] } } };
const main: Block = { type: "lb_main", id: "main", inputs: { DO: { stack: [{ type: "stop", id: "stop" }] } } };
const loose: Block = { type: "stop", id: "loose" };
const PLACES: readonly Place[] = [
  ["set", 1, 1, 1, 1],
  ["main", 4, 6, 4, 6],
  ["stop", 5, 5, 5, 5],
];

test("each stack has its lines, in the order of the text, and a loose one has none", () => {
  expect(linesOfStacks({ stacks: [[loose], [main], [start]] }, TEXT, PLACES)).toEqual([
    { stack: [start], first: 1, lines: ["x = 1"] },
    { stack: [main], first: 3, lines: ["# Go.", "main:", "    stop()", "end"] },
    { stack: [loose], first: 1, lines: [] },
  ]);
});

test("a program without blocks is printed as text", () => {
  expect(linesOfStacks({ stacks: [] }, "# Later.\n", [])).toEqual([{ stack: null, first: 1, lines: ["# Later."] }]);
});

test("a picture is cut above the word that a page would cut", () => {
  const words = [
    { top: 10, bottom: 30 },
    { top: 85, bottom: 105 },
  ];
  expect(bands(150, words, 100)).toEqual([
    { top: 0, bottom: 84 },
    { top: 84, bottom: 150 },
  ]);
});

test("a word higher than a piece is cut", () => {
  expect(bands(250, [{ top: -1, bottom: 251 }], 100).map(({ bottom }) => bottom)).toEqual([100, 200, 250]);
});
