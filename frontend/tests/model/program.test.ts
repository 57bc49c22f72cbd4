import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { beginAnew } from "../../src/model/beginning-anew";
import type { Drafts, Left } from "../../src/model/drafts";
import { Program } from "../../src/model/program";
import type { UnsavedView } from "../../src/model/unsaved";
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

/** Keeps drafts for one project, and has some of an earlier page. */
class FakeDrafts implements Drafts {
  kept: readonly UnsavedView[] = [];
  forgotten = 0;
  /** The project that the drafts are kept for. */
  project = "";

  constructor(private readonly earlier: readonly UnsavedView[]) {}

  keep(project: string, drafts: readonly UnsavedView[]): void {
    this.project = project;
    this.kept = drafts;
  }

  forget(): void {
    this.kept = [];
  }

  async left(): Promise<readonly Left[]> {
    if (this.earlier.length === 0) return [];
    return [{ drafts: this.earlier, forget: () => (this.forgotten += 1) }];
  }
}

function opened(name = "square", earlier: readonly UnsavedView[] = []): [Program, FakeConnection, FakeDrafts] {
  const connection = new FakeConnection();
  const drafts = new FakeDrafts(earlier);
  const program = new Program(connection.real, drafts);
  beginAnew(connection.real, { connected: [program], reset: [program] });
  reopen(connection, name);
  return [program, connection, drafts];
}

/** The server opens a project, and tells what it has. */
function reopen(connection: FakeConnection, name: string, content: object = {}): void {
  connection.tell({ kind: "Opened", name });
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python", ...content });
}

function drawFrame(): void {
  for (const draw of frames.splice(0)) draw();
}

test("edits of one frame are sent as one, the last", () => {
  const [program, connection] = opened();
  for (const text of ["a", "ab", "abc"]) program.editedText("blocktext", () => text);
  drawFrame();
  expect(connection.sent).toEqual([
    { kind: "EditText", edit: 1, revision: 1, shown: 0, notation: "blocktext", text: "abc" },
  ]);
});

test("the drafts of a renamed project move with it, and are sent again under its new name", () => {
  const [program, connection, drafts] = opened("square");
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python" });
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "ProjectRenamed", name: "patrol" });
  expect([drafts.project, drafts.kept.map(({ steps }) => steps)]).toEqual(["patrol", [["", "x = 1"]]]);
  reopen(connection, "patrol");
  expect(connection.sent.at(-1)).toMatchObject({ kind: "RecoverText", text: "x = 1" });
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
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python", blocktext: "x = 1" });
  expect(program.settled).toBe(false);
  expect(program.state.value.blocktext).toBe("");
});

test("the answer to the last edit is shown", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 12");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python", blocktext: "x = 12" });
  expect(program.settled).toBe(true);
  expect(program.state.value).toMatchObject({ blocktext: "x = 12", python: "x = 12", origin: "python" });
});

test("what depends on the places of steps waits until the views show what the server has", () => {
  const [program, connection] = opened();
  const acted: string[] = [];
  const act = () => acted.push(program.state.value.blocktext);
  program.whenSettled(act);
  expect(acted).toEqual([""]);
  program.editedText("blocktext", () => "main:");
  program.whenSettled(act);
  expect(acted).toEqual([""]);
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "blocktext", blocktext: "main:" });
  connection.tell({ kind: "Document", edit: 1, revision: 3, origin: "blocks", blocktext: "end" });
  expect(acted).toEqual(["", "main:"]);
});

test("an answer to an edit of one view does not undo a later edit of another", () => {
  const [program, connection] = opened();
  program.editedText("blocktext", () => "a");
  drawFrame();
  program.editedText("python", () => "newer");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "blocktext", python: "older" });
  connection.tell({ kind: "Document", edit: 2, revision: 3, origin: "python" });
  expect(program.state.value.python).toBe("newer");
});

test("an edit is a draft until the server has saved it", () => {
  const [program, connection, drafts] = opened();
  program.editedText("python", () => "x = 1");
  drawFrame();
  expect(program.saved.value).toBe(false);
  expect(drafts.kept).toEqual([{ view: "python", steps: ["", "x = 1"] }]);
  connection.tell({ kind: "Saved", edit: 1 });
  expect(program.saved.value).toBe(true);
  expect(drafts.kept).toEqual([]);
});

test("saving an earlier edit leaves a later one as a draft of it", () => {
  const [program, connection, drafts] = opened();
  for (const text of ["x = 1", "x = 2"]) {
    program.editedText("python", () => text);
    drawFrame();
  }
  connection.tell({ kind: "Saved", edit: 1 });
  expect(drafts.kept).toEqual([{ view: "python", steps: ["x = 1", "x = 2"] }]);
});

test("an edit names the revision that the views show", () => {
  const [program, connection] = opened();
  connection.tell({ kind: "Document", edit: 0, revision: 7, origin: "python" });
  for (const text of ["x = 1", "x = 2"]) {
    program.editedText("python", () => text);
    drawFrame();
    connection.tell({ kind: "Document", edit: 0, revision: 8, origin: "python" });
  }
  expect(connection.sent.map((edit) => "revision" in edit && edit.revision)).toEqual([7, 7]);
});

test("an unsaved edit of each view is sent again when the same project opens after a lost connection", () => {
  const [program, connection] = opened("square");
  connection.tell({ kind: "Document", edit: 0, revision: 2, origin: "python", python: "x = 0" });
  program.editedText("python", () => "x = 1");
  program.editedText("blocktext", () => "y = 1");
  drawFrame();
  reopen(connection, "square", { python: "x = 0" });
  expect(connection.sent.slice(2)).toEqual([
    { kind: "RecoverText", edit: 1, shown: 0, notation: "python", text: "x = 1", base: "x = 0" },
    { kind: "RecoverText", edit: 2, shown: 0, notation: "blocktext", text: "y = 1", base: "" },
  ]);
});

test("an edit is repeated on the last one that the server has received, saved or not", () => {
  const [program, connection] = opened("square");
  for (const text of ["x = 1", "x = 12", "x = 123"]) {
    program.editedText("python", () => text);
    drawFrame();
  }
  reopen(connection, "square", { python: "x = 12\ny = 1" });
  expect(connection.sent.at(-1)).toMatchObject({ kind: "RecoverText", base: "x = 12", text: "x = 123" });
});

test("what is typed while the project comes back is sent once and in order", () => {
  const [program, connection] = opened("square");
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "Opened", name: "square" });
  program.editedText("python", () => "x = 12");
  drawFrame();
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python" });
  program.editedText("python", () => "x = 123");
  drawFrame();
  expect(connection.sent.slice(1)).toEqual([
    { kind: "RecoverText", edit: 1, shown: 0, notation: "python", text: "x = 12", base: "" },
    { kind: "RecoverText", edit: 2, shown: 0, notation: "python", text: "x = 123", base: "x = 12" },
  ]);
});

test("what is typed between a reconnection and the answer to Open is not sent twice", () => {
  const [program, connection] = opened("square");
  connection.state.value = "lost";
  connection.state.value = "open";
  program.editedText("python", () => "x = 1");
  drawFrame();
  expect(connection.sent).toEqual([]);
  reopen(connection, "square");
  expect(connection.sent).toEqual([
    { kind: "RecoverText", edit: 1, shown: 0, notation: "python", text: "x = 1", base: "" },
  ]);
});

test("an unsaved edit is not carried into another project", () => {
  const [program, connection] = opened("square");
  program.editedText("python", () => "x = 1");
  drawFrame();
  reopen(connection, "dance");
  expect(connection.sent).toHaveLength(1);
  expect(program.saved.value).toBe(true);
});

test("an edit that was undone is not sent again", () => {
  const [program, connection] = opened("square");
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python", python: "" });
  reopen(connection, "square");
  expect(connection.sent.at(-1)).toMatchObject({ kind: "RecoverText", text: "", base: "" });
});

test("what an earlier page has left unsaved is repeated, and forgotten once it is saved", async () => {
  const draft: UnsavedView = { view: "python", steps: ["x = 0", "x = 1"] };
  const [program, connection, drafts] = opened("square", [draft]);
  await vi.waitFor(() => expect(program.recovered.value).toBe(1));
  expect(connection.sent).toEqual([
    { kind: "RecoverText", edit: 1, shown: 0, notation: "python", text: "x = 1", base: "x = 0" },
  ]);
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python", python: "x = 1" });
  expect(program.state.value.python).toBe("x = 1");
  expect(drafts.forgotten).toBe(0);
  connection.tell({ kind: "Saved", edit: 1 });
  expect(drafts.forgotten).toBe(1);
});

test("a refused edit does not keep later answers from being shown", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 1");
  drawFrame();
  connection.tell({ kind: "Failed", message: { code: "server-too-deep" }, refused: "RecoverText" });
  connection.tell({ kind: "Document", edit: 0, revision: 3, origin: "python", blocktext: "y = 1" });
  expect(program.state.value.blocktext).toBe("y = 1");
});

test("a page that only reads sends no edit, and keeps the drafts of earlier pages", async () => {
  const draft: UnsavedView = { view: "python", steps: ["", "x = 1"] };
  const connection = new FakeConnection();
  const drafts = new FakeDrafts([draft]);
  const program = new Program(connection.real, drafts);
  beginAnew(connection.real, { connected: [program], reset: [program] });
  const read_only = { code: "server-reading", values: {} };
  connection.tell({ kind: "Welcome", version: "", robots: [], worlds: [], examples: [], folder: "", read_only });
  connection.tell({ kind: "Opened", name: "square" });
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python" });
  program.editedText("blocktext", () => "x = 2");
  drawFrame();
  program.undo();
  program.redo();
  await Promise.resolve();
  expect(connection.sent).toEqual([]);
  expect(drafts.forgotten).toBe(0);
});

test("the views show what the server has from its first document on, until an edit", () => {
  const connection = new FakeConnection();
  const program = new Program(connection.real, new FakeDrafts([]));
  beginAnew(connection.real, { connected: [program], reset: [program] });
  const settled: boolean[] = [];
  const look = () => settled.push(program.settled);
  connection.tell({ kind: "Opened", name: "square" });
  look();
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python" });
  look();
  program.editedText("python", () => "x = 1");
  look();
  drawFrame();
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python" });
  look();
  connection.tell({ kind: "Document", edit: 1, revision: 3, origin: "blocks", python: "x = 2" });
  look();
  expect(settled).toEqual([false, true, false, true, true]);
});

test("edits of a program that the user leaves are sent when the server sends it again", () => {
  const [program, connection] = opened();
  program.leave();
  program.editedText("python", () => "x = 1");
  drawFrame();
  expect(connection.sent).toEqual([]);
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python" });
  expect(connection.sent).toEqual([
    { kind: "RecoverText", edit: 1, shown: 0, notation: "python", text: "x = 1", base: "" },
  ]);
});

test("an edit before the answer to repeated ones is sent with what it changes", () => {
  const [program, connection] = opened();
  program.editedText("python", () => "x = 1");
  drawFrame();
  reopen(connection, "square");
  program.editedText("blocktext", () => "y = 1");
  drawFrame();
  expect(connection.sent.at(-1)).toEqual({
    kind: "RecoverText",
    edit: 2,
    shown: 0,
    notation: "blocktext",
    text: "y = 1",
    base: "",
  });
  connection.tell({ kind: "Document", edit: 2, revision: 5, origin: "python" });
  program.editedText("python", () => "x = 12");
  drawFrame();
  expect(connection.sent.at(-1)).toMatchObject({ kind: "EditText", edit: 3, revision: 5 });
});

test("an edit made while earlier pages' drafts are looked for is sent before them", async () => {
  const [program, connection] = opened("square", [{ view: "blocktext", steps: ["", "y = 1"] }]);
  program.editedText("python", () => "x = 1");
  drawFrame();
  await vi.waitFor(() => expect(program.recovered.value).toBe(1));
  expect(connection.sent.map((edit) => [edit.kind, "edit" in edit && edit.edit])).toEqual([
    ["EditText", 1],
    ["RecoverText", 2],
  ]);
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python" });
  expect(program.settled).toBe(false);
  connection.tell({ kind: "Document", edit: 2, revision: 3, origin: "python" });
  expect(program.settled).toBe(true);
});

test("earlier pages' drafts are repeated once, not again after a lost connection", async () => {
  const [program, connection] = opened("square", [{ view: "python", steps: ["", "x = 1"] }]);
  await vi.waitFor(() => expect(program.recovered.value).toBe(1));
  connection.tell({ kind: "Document", edit: 1, revision: 2, origin: "python" });
  connection.tell({ kind: "Saved", edit: 1 });
  connection.state.value = "lost";
  connection.state.value = "open";
  reopen(connection, "square");
  await Promise.resolve();
  expect(program.recovered.value).toBe(1);
  expect(connection.sent).toHaveLength(1);
});

test("drafts that are found after another project was opened are not repeated in it", async () => {
  const [program, connection, drafts] = opened("square", [{ view: "python", steps: ["", "x = 1"] }]);
  const found = vi.spyOn(drafts, "left").mockResolvedValue([]);
  reopen(connection, "dance");
  await vi.waitFor(() => expect(found).toHaveBeenCalledWith("dance"));
  await Promise.resolve();
  expect(program.recovered.value).toBe(0);
  expect(connection.sent).toEqual([]);
});
