import type { Mesh } from "three";
import { describe, expect, it } from "vitest";
import type { Stroke } from "../../../src/model/drawing";
import { FloorDrawing } from "../../../src/views/world/drawing";

function line(points: number): Stroke {
  return { color: [1, 2, 3], width: 6, points: Array.from({ length: points }, (_, i) => [i * 3, 0]) };
}

function corners(drawing: FloorDrawing): number {
  const meshes = drawing.object.children as Mesh[];
  return meshes.reduce((sum, mesh) => sum + (mesh.geometry.getAttribute("position")?.count ?? 0), 0);
}

describe("the drawing on the floor", () => {
  it("is empty at first", () => {
    expect(new FloorDrawing().empty).toBe(true);
  });

  it("draws a dot and a line", () => {
    const drawing = new FloorDrawing();
    drawing.show([line(1), line(2)]);
    expect(drawing.empty).toBe(false);
    expect(corners(drawing)).toBeGreaterThan(100);
  });

  it("grows without rebuilding everything", () => {
    const drawing = new FloorDrawing();
    const stroke = line(0);
    const strokes = [stroke];
    for (let i = 0; i < 2000; i++) {
      stroke.points.push([i * 3, 0]);
      drawing.show(strokes);
    }
    expect(drawing.object.children.length).toBe(6);
    expect(corners(drawing)).toBeGreaterThan(2000 * 6 - 12);
  });

  it("shows what two robots draw at the same time", () => {
    const drawing = new FloorDrawing();
    const strokes = [line(1), line(1)];
    drawing.show(strokes);
    const before = corners(drawing);
    for (const stroke of strokes) stroke.points.push([0, 50]);
    drawing.show(strokes);
    expect(corners(drawing)).toBeGreaterThan(before);
  });

  it("is gone when everything was erased", () => {
    const drawing = new FloorDrawing();
    drawing.show([line(5)]);
    drawing.show([]);
    expect(drawing.empty).toBe(true);
    expect(corners(drawing)).toBe(0);
  });
});

describe("the drawing on a dark floor", () => {
  it("gives dark strokes a light edge on a dark floor", () => {
    const drawing = new FloorDrawing();
    drawing.show([line(2)]);
    const before = corners(drawing);
    drawing.on("#323c70");
    expect(corners(drawing)).toBe(2 * before);
    drawing.on("#fdf6e6");
    expect(corners(drawing)).toBe(before);
  });

  it("leaves light strokes on a dark floor as they are", () => {
    const drawing = new FloorDrawing();
    drawing.on("#323c70");
    drawing.show([{ ...line(2), color: [255, 220, 80] }]);
    const plain = new FloorDrawing();
    plain.show([line(2)]);
    expect(corners(drawing)).toBe(corners(plain));
  });
});
