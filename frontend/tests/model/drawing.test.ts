import { describe, expect, it } from "vitest";
import { Drawing } from "../../src/model/drawing";
import type { Drawing as News, StrokePart } from "../../src/protocol/messages";

function news(fresh: boolean, ...parts: StrokePart[]): News {
  return { kind: "Drawing", fresh, parts };
}

function part(stroke: number, ...points: [number, number][]): StrokePart {
  return { stroke, color: [200, 0, 0], width: 6, points };
}

describe("the drawing", () => {
  it("grows with each message", () => {
    const drawing = new Drawing();
    drawing.receive(news(true, part(0, [0, 0])));
    drawing.receive(news(false, part(0, [3, 0]), part(1, [9, 9])));
    expect(drawing.strokes.map(({ points }) => points)).toEqual([
      [
        [0, 0],
        [3, 0],
      ],
      [[9, 9]],
    ]);
    expect(drawing.changes.value).toBe(2);
  });

  it("starts again once everything has been erased", () => {
    const drawing = new Drawing();
    drawing.receive(news(true, part(0, [0, 0])));
    const before = drawing.strokes;
    drawing.receive({ kind: "Drawing", fresh: true });
    expect(drawing.strokes).toEqual([]);
    expect(drawing.strokes).not.toBe(before);
  });
});
