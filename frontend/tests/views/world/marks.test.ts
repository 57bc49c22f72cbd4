import { describe, expect, it } from "vitest";
import { farthestLine } from "../../../src/views/world/marks";
import type { WorldValues, XY } from "../../../src/views/world/scenery/description";

function lines(...places: number[]): WorldValues {
  const across = (x: number): XY[] => [
    [x, -100],
    [x, 100],
  ];
  return { line: places.map((x) => ({ points: across(x) })) } as unknown as WorldValues;
}

describe("a world without goals is about", () => {
  it("the farthest line that is near", () => {
    expect(farthestLine(lines(300, 900, 500, 2500), 0, 0)).toEqual([900, 0]);
  });

  it("nothing without one", () => {
    expect(farthestLine(lines(2500), 0, 0)).toBeNull();
  });
});
