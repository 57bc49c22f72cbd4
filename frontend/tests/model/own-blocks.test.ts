import { expect, test } from "vitest";

import { freeName, nameFault, nameInTexts, takenNames } from "../../src/model/own-block-names";
import { callInText, type OwnBlock, withChanged, withNew } from "../../src/model/own-blocks";
import type { Block, Workspace } from "../../src/protocol/messages";

const DANCE: OwnBlock = {
  name: "dance",
  inputs: [
    { name: "rounds", sample: 3 },
    { name: "music", sample: true },
  ],
};

const number = (id: string, value: number): Block => ({ id, type: "math_number", fields: { NUM: value } });

/** A program with the definition of `dance`, which uses its first input, and calls of it. */
function program(): Workspace {
  const calls: Block[] = [
    {
      type: "procedures_callnoreturn",
      id: "call",
      extraState: { name: "dance", params: ["rounds", "music"] },
      inputs: { ARG0: { shadow: number("three", 3) }, ARG1: { block: number("other", 1) } },
    },
    {
      type: "lb_call",
      id: "named",
      fields: { NAME: "dance" },
      extraState: { name: "dance", arguments: 1, keywords: ["music"] },
    },
  ];
  const use = (id: string): Block => ({ type: "variables_get", id, fields: { VAR: { id: "v1" } } });
  const definition: Block = {
    type: "procedures_defnoreturn",
    id: "def",
    x: 7,
    fields: { NAME: "dance" },
    extraState: {
      params: [
        { name: "rounds", id: "v1", sample: 3 },
        { name: "music", id: "v2", sample: true },
      ],
    },
    inputs: { STACK: { stack: [{ type: "lb_do", id: "do", inputs: { VALUE: { block: use("inside") } } }] } },
  };
  const outside: Block = { type: "lb_do", id: "do2", inputs: { VALUE: { block: use("outside") } } };
  return {
    stacks: [[{ type: "lb_main", id: "main", inputs: { DO: { stack: [...calls, outside] } } }], [definition]],
    variables: [
      { name: "rounds", id: "v1" },
      { name: "music", id: "v2" },
    ],
  };
}

function bodyOf({ stacks }: Workspace): Block[] {
  return stacks[0]![0]!.inputs!.DO!.stack!;
}

const EDITED: OwnBlock = {
  name: "tango",
  inputs: [
    { name: "music", sample: true, was: 1 },
    { name: "turns", sample: 3, was: 0 },
    { name: "shout", sample: "hey" },
  ],
};

test("a new block is a definition at the end of the program, with a variable for each input", () => {
  const { program: made, id } = withNew({ stacks: [], variables: [{ name: "rounds", id: "own1" }] }, DANCE);
  const params = [
    { name: "rounds", id: "own1", sample: 3 },
    { name: "music", id: "own2", sample: true },
  ];
  expect(made.stacks).toEqual([
    [{ type: "procedures_defnoreturn", id, fields: { NAME: "dance" }, extraState: { params } }],
  ]);
  expect(made.variables.map(({ name }) => name)).toEqual(["rounds", "music"]);
});

test("a definition keeps what says that its variables are its own", () => {
  const { program: made, id } = withNew({ stacks: [], variables: [] }, { name: "go", inputs: [] }, { hasLocals: true });
  expect(made.stacks[0]![0]!.extraState).toEqual({ locals: true });
  const changed = withChanged(made, id, { name: "run", inputs: [{ name: "fast", sample: true }] });
  expect(changed.stacks[0]![0]!.extraState).toMatchObject({ params: [{ name: "fast" }], locals: true });
});

test("the calls of a changed block keep the values of the inputs that stay, wherever these are now", () => {
  const [call] = bodyOf(withChanged(program(), "def", EDITED));
  expect(call!.extraState).toEqual({ name: "tango", params: ["music", "turns", "shout"] });
  expect(call!.inputs!.ARG0).toEqual({ block: number("other", 1) });
  expect(call!.inputs!.ARG1).toEqual({ shadow: number("three", 3) });
  expect(call!.inputs!.ARG2!.shadow).toMatchObject({ type: "text", fields: { TEXT: "hey" } });
});

test("a call with arguments by name follows the new names", () => {
  const [, call] = bodyOf(
    withChanged(program(), "def", { ...EDITED, inputs: [{ name: "song", sample: true, was: 1 }] }),
  );
  expect(call!.fields).toEqual({ NAME: "tango" });
  expect(call!.extraState).toEqual({ name: "tango", arguments: 1, keywords: ["song"] });
});

test("a renamed input is renamed inside the definition, and the variable of that name elsewhere is not", () => {
  const changed = withChanged(program(), "def", EDITED);
  const [definition] = changed.stacks[1]!;
  const turns = changed.variables.find(({ name }) => name === "turns")!;
  expect(definition!.x).toBe(7);
  expect(definition!.inputs!.STACK!.stack![0]!.inputs!.VALUE!.block!.fields).toEqual({ VAR: { id: turns.id } });
  expect(bodyOf(changed)[2]!.inputs!.VALUE!.block!.fields).toEqual({ VAR: { id: "v1" } });
});

test("two inputs can swap their names", () => {
  const [first, second] = DANCE.inputs;
  const inputs = [
    { ...first!, name: "music", was: 0 },
    { ...second!, name: "rounds", was: 1 },
  ];
  const [definition] = withChanged(program(), "def", { ...DANCE, inputs }).stacks[1]!;
  expect(definition!.inputs!.STACK!.stack![0]!.inputs!.VALUE!.block!.fields).toEqual({ VAR: { id: "v2" } });
});

test("a change that changes nothing leaves the program as it is", () => {
  const inputs = DANCE.inputs.map((input, was) => ({ ...input, was }));
  expect(withChanged(program(), "def", { ...DANCE, inputs })).toEqual(program());
});

test("a block without inputs has no list of them", () => {
  const changed = withChanged(program(), "def", { name: "dance", inputs: [] });
  expect(changed.stacks[1]![0]!.extraState).toBeUndefined();
  expect(bodyOf(changed)[0]!.extraState).toEqual({ name: "dance" });
});

test("a call is written as both texts write it", () => {
  const text = { name: "name", sample: 'a "b"' };
  expect(callInText({ ...DANCE, inputs: [...DANCE.inputs, text] })).toBe('dance(3, True, "a \\"b\\"")');
});

test.each([
  ["go home", "go_home"],
  [" ir a casa! ", "ir_a_casa_"],
  ["2 steps", "_2_steps"],
  ["größe", "größe"],
  ["ｗide", "wide"],
])("the words %j become the name %j", (typed, name) => {
  expect(nameInTexts(typed)).toBe(name);
});

test.each([
  ["", "page-make-unnamed"],
  ["  ", "page-make-unnamed"],
  ["?!", "page-make-unnamed"],
  ["while", "page-make-reserved"],
  ["True", "page-make-reserved"],
  ["Dance", "page-make-taken"],
  ["rounds", "page-make-taken"],
  ["waltz", ""],
])("the name %j has the fault %j", (typed, fault) => {
  expect(nameFault(typed, takenNames(program()))).toBe(fault);
});

test("a block may keep its own name", () => {
  expect(nameFault("dance", takenNames(program(), "def"))).toBe("");
});

test("a second input of a kind gets a name of its own", () => {
  expect(freeName("number", ["number", "number2"])).toBe("number3");
});
