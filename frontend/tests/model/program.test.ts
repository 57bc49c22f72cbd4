import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { Program } from "../../src/model/program";
import { FakeConnection } from "../fake-connection";

let frames: (() => void)[] = [];

beforeEach(() => {
  frames = [];
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => frames.push(draw));
  vi.stubGlobal("cancelAnimationFrame", () => {
    frames = [];
  });
});
afterEach(() => vi.unstubAllGlobals());

function opened(name = "square"): [Program, FakeConnection] {
  const connection = new FakeConnection();
  const program = new Program(connection.real);
  connection.tell({ kind: "Opened", name });
  return [program, connection];
}

function drawFrame(): void {
  for (const draw of frames.splice(0)) draw();
}

test("edits of one frame are sent as one, the last", () => {
  const [program, connection] = opened();
  for (const text of ["a", "ab", "abc"]) program.editedText("blocktext", () => text);
  drawFrame();
  expect(connection.sent).toEqual([{ kind: "EditText", edit: 1, notation: "blocktext", text: "abc" }]);
});

test("an undo sends what was edited before it", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 1");
  program.undo();
  expect(connection.sent.map(({ kind }) => kind)).toEqual(["EditText", "Undo"]);
});

test("a document that answers an earlier edit is not shown", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 1");
  drawFrame();
  program.editedText("python", () => "x = 12");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, origin: "python", blocktext: "x = 1" });
  expect(program.settled).toBe(false);
  expect(program.state.value.blocktext).toBe("");
});

test("the answer to the last edit is shown", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 12");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, origin: "python", blocktext: "x = 12" });
  expect(program.settled).toBe(true);
  expect(program.state.value).toMatchObject({ blocktext: "x = 12", python: "x = 12", origin: "python" });
});

test("an answer to an edit of one view does not undo a later edit of another", () => {
  const [program, connection] = opened();
  program.editedText("blocktext", () => "a");
  drawFrame();
  program.editedText("python", () => "newer");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, origin: "blocktext", python: "older" });
  connection.tell({ kind: "Document", edit: 2, origin: "python" });
  expect(program.state.value.python).toBe("newer");
});

test("an edit is unsaved until the server has saved it", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 1");
  drawFrame();
  expect(program.unsaved.value).toEqual({ view: "python", content: "x = 1" });
  connection.tell({ kind: "Saved", edit: 1 });
  expect(program.unsaved.value).toBeNull();
});

test("saving an earlier edit leaves a later one unsaved", () => {
  const [program, connection] = opened();
  for (const text of ["x = 1", "x = 2"]) {
    program.editedText("python", () => text);
    drawFrame();
  }
  connection.tell({ kind: "Saved", edit: 1 });
  expect(program.unsaved.value).toEqual({ view: "python", content: "x = 2" });
});

test("an unsaved edit is sent again when the same project opens after a lost connection", () => {
  const [program, connection] = opened("square");
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "Opened", name: "square" });
  expect(connection.sent.at(-1)).toEqual({ kind: "EditText", edit: 1, notation: "python", text: "x = 1" });
  expect(connection.sent).toHaveLength(2);
});

test("an unsaved edit is not carried into another project", () => {
  const [program, connection] = opened("square");
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "Opened", name: "dance" });
  expect(connection.sent).toHaveLength(1);
  expect(program.unsaved.value).toBeNull();
});

test("an edit that was undone is not sent again", () => {
  const [program, connection] = opened("square");
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, origin: "python", python: "" });
  connection.tell({ kind: "Opened", name: "square" });
  expect(connection.sent).toHaveLength(1);
});
