import { describe, expect, it } from "vitest";
import type { Block, Workspace } from "../../../src/protocol/messages";
import { blocksIn, blocksOf, fold, hiddenIn, LARGE, REST, restOf, unfold } from "../../../src/views/blocks/folds";

function chain(name: string, size: number): Block[] {
  return Array.from({ length: size }, (_, at) => ({ type: "lb_pass", id: `${name}${at}` }));
}

function definition(name: string, size: number): Block[] {
  return [{ type: "procedures_defnoreturn", id: name, inputs: { STACK: { stack: chain(`${name}-`, size) } } }];
}

function program(...stacks: Block[][]): Workspace {
  return { stacks, variables: [] };
}

const never = () => false;
const keep = () => [];

function rests(workspace: Workspace): Block[] {
  return [...blocksIn(workspace.stacks.flat())].filter(({ type }) => type === REST);
}

describe("a folded program", () => {
  it("is the program itself if that is small", () => {
    const small = program(definition("f", LARGE - 1));
    expect(fold(small, never)).toBe(small);
  });

  it("has one block for the body of each function", () => {
    const large = program(definition("f", LARGE), definition("g", 9));
    expect(rests(fold(large, never)).map((block) => restOf(block)?.count)).toEqual([LARGE, 9]);
  });

  it("draws short functions and those that are open", () => {
    const large = program(definition("f", LARGE), definition("g", 9), definition("h", 2));
    const folded = fold(large, ([first]) => first?.id === "g-0");
    expect(rests(folded)).toHaveLength(1);
    expect(folded.stacks.slice(1)).toEqual(large.stacks.slice(1));
  });

  it("has one block for neighbouring pieces of a list, and more where one of them is drawn", () => {
    const large = program(chain("s", 5 * LARGE));
    expect(rests(fold(large, never))).toHaveLength(1);
    const around = fold(large, (blocks) => blocks.some(({ id }) => id === "s700"));
    expect(rests(around)).toHaveLength(2);
    expect(around.stacks[0]?.some(({ id }) => id === "s700")).toBe(true);
  });

  it("keeps the ends of pieces where statements are added elsewhere", () => {
    const ends = (size: number) => {
      const [rest] = rests(fold(program([...chain("new", size), ...chain("s", 2 * LARGE)]), never));
      return new Set(rest && restOf(rest)?.pieces.map((piece) => piece.at(-1)?.id));
    };
    const [before, after] = [ends(0), ends(1)];
    expect([...after].filter((id) => !before.has(id)).length).toBeLessThan(4);
  });

  it("cuts the list in a long loop, which is drawn itself", () => {
    const loop: Block = { type: "controls_repeat", id: "loop", inputs: { DO: { stack: chain("s", LARGE) } } };
    const [[drawn] = []] = fold(program([loop, ...chain("after", 20)]), never).stacks;
    expect(drawn?.id).toBe("loop");
    expect(drawn?.inputs?.DO?.stack?.map(({ type }) => type)).toEqual([REST]);
  });
});

describe("what is folded", () => {
  it("is the whole program again when it is unfolded", () => {
    const large = program(definition("f", LARGE), chain("s", LARGE), definition("g", 2));
    expect(unfold(fold(large, never), keep)).toEqual(large);
    expect(
      unfold(
        fold(large, ([first]) => first?.id === "f-0"),
        keep,
      ),
    ).toEqual(large);
  });

  it("unfolds a copied block to a copy of what it stands for", () => {
    const folded = fold(program(definition("f", LARGE)), never);
    const [rest] = rests(folded);
    const copy = program([{ ...rest!, id: "copy" }]);
    const unfolded = unfold(copy, (one, id) => blocksOf(one).map((block) => ({ ...block, id: `${id} ${block.id}` })));
    expect(unfolded.stacks[0]?.slice(0, 2).map(({ id }) => id)).toEqual(["copy f-0", "copy f-1"]);
  });

  it("knows the block that stands for each hidden block", () => {
    const hidden = hiddenIn(fold(program(definition("f", LARGE)), never));
    expect(hidden.size).toBe(LARGE);
    expect(hidden.get("f-7")).toBe(`${REST}:f-0`);
  });
});
