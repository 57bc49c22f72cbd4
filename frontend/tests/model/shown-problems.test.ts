import { expect, test } from "vitest";

import { type Checked, ShownProblems } from "../../src/model/shown-problems";
import type { Block, Problem } from "../../src/protocol/messages";

function block(id: string, inside: readonly Block[] = []): Block {
  return { id, type: "any", inputs: inside.length ? { DO: { stack: [...inside] } } : {} } as Block;
}

function warning(code: string, id: string, message = code): Problem {
  return { code, block: id, severity: "warning", view: "blocks", message: { code: message } };
}

function program(blocks: readonly Block[], problems: readonly Problem[] = []): Checked {
  return { workspace: { stacks: [[block("hat", blocks)]], variables: [] }, problems, origin: "blocks" };
}

/** The codes that are shown after each of some states of a program. */
function shown(...states: readonly Checked[]): string[] {
  const problems = new ShownProblems();
  return states.map((state) => codes(problems.after(state)));
}

function codes(problems: readonly Problem[]): string {
  return problems.map(({ code, block }) => `${code} ${block}`).join();
}

const EMPTY_REPEAT = warning("empty-block", "repeat");

test("a program that is opened shows all its problems", () => {
  expect(shown(program([block("repeat")], [EMPTY_REPEAT]))).toEqual(["empty-block repeat"]);
});

test("an empty block that has just been placed is warned about once another is placed", () => {
  const placed = program([block("repeat")], [EMPTY_REPEAT]);
  const sameAgain = program([block("repeat")], [EMPTY_REPEAT]);
  const next = program([block("repeat"), block("drive")], [EMPTY_REPEAT]);
  expect(shown(program([]), placed, sameAgain, next)).toEqual(["", "", "", "empty-block repeat"]);
});

test("a loop without an end that is still empty waits too, and other problems do not", () => {
  const problems = [warning("idle-loop", "forever", "check-idle-loop"), warning("unreachable", "forever")];
  expect(shown(program([]), program([block("forever")], problems))).toEqual(["", "unreachable forever"]);
});

test("a block that gets its condition first still waits for what is inside", () => {
  const placed = program([block("if")], [warning("missing-condition", "if"), warning("empty-block", "if")]);
  const filled = program(
    [block("if", [block("equal")])],
    [warning("empty-block", "if"), warning("missing-condition", "equal")],
  );
  expect(shown(program([]), placed, filled)).toEqual(["", "", ""]);
});

test("a mistake that keeps the program from running is shown at once", () => {
  const wrong: Problem = { ...warning("missing-value", "each"), severity: "error" };
  expect(shown(program([]), program([block("each")], [wrong]))).toEqual(["", "missing-value each"]);
});

test("a run shows what waits", () => {
  const problems = new ShownProblems();
  problems.after(program([]));
  expect(codes(problems.after(program([block("repeat")], [EMPTY_REPEAT])))).toBe("");
  expect(codes(problems.all())).toBe("empty-block repeat");
  expect(codes(problems.after(program([block("repeat")], [EMPTY_REPEAT])))).toBe("empty-block repeat");
});

test("what is edited in a text, and what another program has, is shown at once", () => {
  const inText: Checked = { ...program([block("repeat")], [EMPTY_REPEAT]), origin: "blocktext" };
  expect(shown(program([]), inText)).toEqual(["", "empty-block repeat"]);
  const problems = new ShownProblems();
  problems.after(program([]));
  problems.reset();
  expect(codes(problems.after(program([block("repeat")], [EMPTY_REPEAT])))).toBe("empty-block repeat");
});

function lacking(severity: Problem["severity"], ...kinds: string[]): Problem {
  const devices = kinds.map((kind) => ({ code: "check-device", values: { kind, key: "" } }));
  const message = { code: "check-skill-without-effect", values: { skill: "any", devices } };
  return { ...warning("missing-device", kinds.join()), severity, message };
}

test("sounds that this computer plays for the robot are no problem", () => {
  const problems = [lacking("warning", "Speaker"), lacking("warning", "Display"), lacking("error", "Speaker")];
  const [only] = shown(program([], [...problems, lacking("warning", "Speaker", "MP3")]));
  expect(only).toBe("missing-device Display,missing-device Speaker,missing-device Speaker,MP3");
});
