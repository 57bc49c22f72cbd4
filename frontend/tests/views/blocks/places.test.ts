import type * as Blockly from "blockly/core";
import { expect, test } from "vitest";

import { separate } from "../../../src/views/blocks/places";

class Area {
  constructor(
    readonly top: number,
    readonly bottom: number,
    readonly left: number,
    readonly right: number,
  ) {}

  intersects(other: Area): boolean {
    return this.left < other.right && other.left < this.right && this.top < other.bottom && other.top < this.bottom;
  }
}

/** A stack of blocks on a wide screen, 100 wide. */
class Stack {
  readonly workspace = { horizontalLayout: false };

  constructor(
    readonly x: number,
    public y: number,
    private readonly height: number,
  ) {}

  getRelativeToSurfaceXY() {
    return { x: this.x, y: this.y };
  }

  getBoundingRectangle() {
    const { x, y, height } = this;
    return new Area(y, y + height, x, x + 100);
  }

  moveBy(_x: number, y: number) {
    this.y += y;
  }
}

function separated(...stacks: Stack[]): number[] {
  separate(stacks as unknown as Blockly.BlockSvg[]);
  return stacks.map(({ y }) => y);
}

test("stacks that do not touch stay where they are", () => {
  expect(separated(new Stack(0, 0, 80), new Stack(0, 100, 80), new Stack(200, 20, 80))).toEqual([0, 100, 20]);
});

test("stacks that were placed where blocks are lower do not cover each other", () => {
  expect(separated(new Stack(0, 0, 120), new Stack(0, 100, 120), new Stack(0, 200, 80))).toEqual([0, 160, 320]);
});

test("a stack that is pushed is below all that it reaches", () => {
  expect(separated(new Stack(0, 0, 120), new Stack(50, 10, 300), new Stack(0, 100, 80))).toEqual([0, 160, 500]);
});
