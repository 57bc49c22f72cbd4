// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { beforeEach, expect, test, vi } from "vitest";

import { revealAround, runHandIn } from "../../src/features/hand-ins/run";
import type { Page } from "../../src/model/page";
import { Views } from "../../src/model/views";
import { FakeConnection } from "../fake-connection";

const PROGRAM = "main:\n    pass\nend\n";
const RUN = { lesson: "square", step: 4, program: { text: PROGRAM }, robot: "sim-thymio", variant: 2 };

function opened() {
  const connection = new FakeConnection();
  const edited = vi.fn((_: string, read: () => string) => connection.send({ kind: "EditText", text: read() } as never));
  const program = { state: signal({ blocktext: "" }), editedText: edited, flush: vi.fn() };
  const lessons = { shown: signal<{ name: string; step: number } | null>(null) };
  runHandIn({ context: { connection, program }, lessons } as unknown as Page);
  return { connection, program, lessons, kinds: () => connection.sent.map(({ kind }) => kind) };
}

let page: ReturnType<typeof opened>;

beforeEach(() => {
  page = opened();
  page.connection.tell({ kind: "HandInRun", ...RUN } as never);
});

function arrive(step = 4): void {
  page.program.state.value = { blocktext: "main:\n    repeat 2:\n    end\nend\n" };
  page.lessons.shown.value = { name: "square", step };
}

test("nothing runs before the server is at the step", () => {
  arrive(3);
  expect(page.kinds()).toEqual([]);
});

test("what was handed in runs once, as fast as it can, in the world of the check", () => {
  arrive();
  page.program.state.value = { blocktext: PROGRAM };
  expect(page.kinds()).toEqual(["EditText", "SetSpeed", "ShowVariant"]);
  expect(page.program.editedText.mock.calls[0]![0]).toBe("blocktext");
  expect(page.connection.sent).toContainEqual({ kind: "SetSpeed", factor: null });
  expect(page.connection.sent).toContainEqual({ kind: "ShowVariant", robot: "sim-thymio", variant: 2 });
});

test("a program in Python is given as Python", () => {
  page.connection.tell({ kind: "HandInRun", ...RUN, program: { text: "pass\n", is_python: true } } as never);
  arrive();
  expect(page.program.editedText.mock.calls[0]![0]).toBe("python");
});

test("later runs are to be watched, and the end of an earlier one changes nothing", () => {
  page.connection.tell({ kind: "Ended" });
  expect(page.kinds()).toEqual([]);
  arrive();
  page.connection.tell({ kind: "Ended" });
  page.connection.tell({ kind: "Ended" });
  expect(page.connection.sent.filter(({ kind }) => kind === "SetSpeed")).toEqual([
    { kind: "SetSpeed", factor: null },
    { kind: "SetSpeed", factor: 1 },
  ]);
});

test("the page around it shows the block that an answer names, also of a panel on a narrow page", () => {
  const told = vi.spyOn(parent, "postMessage").mockImplementation(() => {});
  const views = new Views();
  const program = { state: signal({ places: [["repeat", 2, 4, 5, 6]] }) };
  revealAround({ views, context: { program } } as unknown as Page);
  views.showPanel("why");
  expect(views.area.value).toBe("blocks");
  views.reveal("unknown");
  expect(told).not.toHaveBeenCalled();
  views.reveal("repeat");
  expect(told).toHaveBeenCalledWith({ showLine: 2 }, location.origin);
});
