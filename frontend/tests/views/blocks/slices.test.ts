import { describe, expect, it } from "vitest";
import type { Block, Workspace } from "../../../src/protocol/messages";
import { index } from "../../../src/views/blocks/flat";
import { AT_ONCE, slices } from "../../../src/views/blocks/slices";

const NOTHING: Workspace = { stacks: [], variables: [] };

function stack(name: string, size: number, place: Partial<Block> = {}): Block[] {
  const chain = Array.from({ length: size }, (_, at): Block => ({ type: "lb_pass", id: `${name}${at}` }));
  return [{ ...chain[0]!, ...place }, ...chain.slice(1)];
}

function workspace(...stacks: Block[][]): Workspace {
  return { stacks, variables: [{ name: "x", id: "x" }] };
}

describe("a program in slices", () => {
  it("is shown at once if it is small", () => {
    const wanted = workspace(stack("a", AT_ONCE));
    expect(slices(index(NOTHING), wanted)).toEqual({ now: wanted, later: [] });
  });

  it("is shown stack by stack if it is large, with all variables from the start", () => {
    const wanted = workspace(stack("a", AT_ONCE), stack("b", 1));
    expect(slices(index(NOTHING), wanted)).toEqual({ now: { ...wanted, stacks: [] }, later: wanted.stacks });
  });

  it("keeps what is shown and adds only new stacks later", () => {
    const [old, added] = [stack("a", 5), stack("b", AT_ONCE + 1)];
    const changed = [{ ...old[0]!, data: "changed" }, ...old.slice(1)];
    const wanted = workspace(added, changed);
    expect(slices(index(workspace(old)), wanted)).toEqual({ now: { ...wanted, stacks: [changed] }, later: [added] });
  });

  it("moves blocks and shadows that exist at once", () => {
    const shadow: Block = { type: "math_number", id: "number" };
    const old = [{ type: "lb_wait", id: "a", inputs: { TIME: { shadow } } }];
    const moved = [...stack("b", AT_ONCE + 1), { type: "lb_wait", id: "c", inputs: { TIME: { shadow } } }];
    const wanted = workspace(moved);
    expect(slices(index(workspace(old)), wanted)).toEqual({ now: wanted, later: [] });
  });

  it("adds stacks without a position last, below all others", () => {
    const [free, placed] = [stack("a", AT_ONCE), stack("b", AT_ONCE, { x: 1, y: 2 })];
    expect(slices(index(NOTHING), workspace(free, placed)).later).toEqual([placed, free]);
  });
});
